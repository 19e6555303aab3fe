// mutant: a mirror in the shadow ends the ray
// task: ray_color
// caught by: color-mirrors
// says: no light reaches|expected
// alone: passes, as no light of a stand-in is 0
    float weight = 1.0f;
    for (int bounce = 0;; bounce++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            color += weight * scene->background;
            break;
        }
        const Surface surface = surface_at(ray, hit, scene);
        const float3 own = lit_color(surface.point, surface.normal, surface.material, scene, work);
        color += weight * own;
        weight *= surface.material.ks;
        if (bounce == max_bounces || weight < LEAST_WEIGHT ||
            (own.x == 0.0f && own.y == 0.0f && own.z == 0.0f)) {
            break;
        }
        ray.origin = surface.point;
        ray.direction = mirrored_direction(ray.direction, surface.normal);
    }
