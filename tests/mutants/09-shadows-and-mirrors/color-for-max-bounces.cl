// mutant: the loop runs max_bounces times: without mirrors no ray is sent
// task: ray_color
// caught by: color-rays
// says: the last rays are not sent
    float weight = 1.0f;
    for (int i = 0; i < max_bounces; i++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            return color + weight * scene->background;
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
