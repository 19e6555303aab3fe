// mutant: a Work of its own for lit_color
// task: ray_color
// caught by: color-rays
// says: passed on to lit_color
    float weight = 1.0f;
    Work own = {0, 0, 0, 0};
    for (int bounce = 0;; bounce++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            return color + weight * scene->background;
        }
        const Surface at = surface_at(ray, hit, scene);
        color += weight * lit_color(at.point, at.normal, at.material, scene, &own);
        weight *= at.material.ks;
        if (bounce == max_bounces || weight < LEAST_WEIGHT) {
            return color;
        }
        ray.origin = at.point;
        ray.direction = mirrored_direction(ray.direction, at.normal);
    }
