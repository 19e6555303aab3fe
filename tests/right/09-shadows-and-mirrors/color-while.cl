// right: a loop that counts down, with one exit
// task: ray_color
    float weight = 1.0f;
    int n_left = max_bounces;
    int goes_on = 1;
    while (goes_on) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        goes_on = hit.sphere != NO_SPHERE;
        if (!goes_on) {
            color += weight * scene->background;
        } else {
            const Surface at = surface_at(ray, hit, scene);
            color += weight * lit_color(at.point, at.normal, at.material, scene, work);
            weight *= at.material.ks;
            goes_on = n_left-- > 0 && weight >= LEAST_WEIGHT;
            ray.direction = mirrored_direction(ray.direction, at.normal);
            ray.origin = at.point;
        }
    }
