// mutant: the end is at a whole step of a PNG
// task: ray_color
// caught by: color-end
// says: end were above
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
        if (bounce == max_bounces || weight < 1.0f / 255.0f) {
            break;
        }
        ray.origin = surface.point;
        ray.direction = mirrored_direction(ray.direction, surface.normal);
    }
