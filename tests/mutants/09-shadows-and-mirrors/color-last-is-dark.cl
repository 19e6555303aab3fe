// mutant: what is hit last adds nothing
// task: ray_color
// caught by: color-local
// says: after max_bounces mirrors
    float weight = 1.0f;
    for (int bounce = 0;; bounce++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            return color + weight * scene->background;
        }
        if (bounce == max_bounces) {
            return color;
        }
        const Surface at = surface_at(ray, hit, scene);
        color += weight * lit_color(at.point, at.normal, at.material, scene, work);
        weight *= at.material.ks;
        if (weight < LEAST_WEIGHT) {
            return color;
        }
        ray.origin = at.point;
        ray.direction = mirrored_direction(ray.direction, at.normal);
    }
