// right: a new ray for each mirror, the end asked at the top
// task: ray_color
    float weight = 1.0f;
    for (int i = 0; i <= max_bounces && (i == 0 || weight >= LEAST_WEIGHT); i++) {
        const Hit hit =
            trace(ray, scene->spheres, scene->nodes, scene->sphere_ids, scene->bounds, work);
        if (hit.sphere == NO_SPHERE) {
            color += weight * scene->background;
            break;
        }
        const Surface at = surface_at(ray, hit, scene);
        const Ray next = {at.point, mirrored_direction(ray.direction, at.normal), 0.0f, INFINITY};
        color += weight * lit_color(at.point, at.normal, at.material, scene, work);
        weight = weight * at.material.ks;
        ray = next;
    }
