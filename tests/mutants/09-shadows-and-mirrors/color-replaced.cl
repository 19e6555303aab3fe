// mutant: = for +=: the last hit alone
// task: ray_color
// caught by: color-mirrors
// says: took the place|expected
    float weight = 1.0f;
    for (int bounce = 0;; bounce++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            return color + weight * scene->background;
        }
        const Surface at = surface_at(ray, hit, scene);
        color = weight * lit_color(at.point, at.normal, at.material, scene, work);
        weight *= at.material.ks;
        if (bounce == max_bounces || weight < LEAST_WEIGHT) {
            return color;
        }
        ray.origin = at.point;
        ray.direction = mirrored_direction(ray.direction, at.normal);
    }
