// mutant: the sum is cut at 1
// task: ray_color
// caught by: color-end
// says: cut at 1|expected
    float weight = 1.0f;
    for (int bounce = 0;; bounce++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            color += weight * scene->background;
            break;
        }
        const Surface surface = surface_at(ray, hit, scene);
        color += weight * lit_color(surface.point, surface.normal, surface.material, scene, work);
        weight *= surface.material.ks;
        if (bounce == max_bounces || weight < LEAST_WEIGHT) {
            break;
        }
        ray.origin = surface.point;
        ray.direction = mirrored_direction(ray.direction, surface.normal);
    }
    color = clamp(color, 0.0f, 1.0f);
