// mutant: the ray behind the last mirror is traced, and what it hits thrown away
// task: ray_color
// caught by: color-rays
// says: adds nothing
    float weight = 1.0f;
    for (int n_bounces = 0;; n_bounces++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            return color + weight * scene->background;
        }
        const Surface at = surface_at(ray, hit, scene);
        color += weight * lit_color(at.point, at.normal, at.material, scene, work);
        weight *= at.material.ks;
        ray.origin = at.point;
        ray.direction = mirrored_direction(ray.direction, at.normal);
        if (n_bounces == max_bounces || weight < LEAST_WEIGHT) {
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
            return color;
        }
    }
