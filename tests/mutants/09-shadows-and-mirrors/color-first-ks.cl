// mutant: the first mirror's ks for all of them
// task: ray_color
// caught by: color-mirrors
// says: ks of the first mirror
    float weight = 1.0f;
    float ks = -1.0f;
    for (int bounce = 0;; bounce++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            color += weight * scene->background;
            break;
        }
        const Surface surface = surface_at(ray, hit, scene);
        color += weight * lit_color(surface.point, surface.normal, surface.material, scene, work);
        ks = ks < 0.0f ? surface.material.ks : ks;
        weight *= ks;
        if (bounce == max_bounces || weight < LEAST_WEIGHT) {
            break;
        }
        ray.origin = surface.point;
        ray.direction = mirrored_direction(ray.direction, surface.normal);
    }
