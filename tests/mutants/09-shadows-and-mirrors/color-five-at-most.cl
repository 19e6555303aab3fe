// mutant: never more than five mirrors
// task: ray_color
// caught by: color-end
// says: five mirrors at most
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
        if (bounce == min(max_bounces, 5) || weight < LEAST_WEIGHT) {
            break;
        }
        ray.origin = surface.point;
        ray.direction = mirrored_direction(ray.direction, surface.normal);
    }
