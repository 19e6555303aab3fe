// right: the last light first
// task: lit_color
    for (int i = scene->n_lights - 1; i >= 0; i--) {
        const float3 way = to_float3(scene->lights[i].position) - point;
        if (dot(normal, way) <= 0.0f) {
            continue;
        }
        if (!is_blocked(shadow_ray(point, scene->lights[i]), scene, work)) {
            color = color + shade(point, normal, material, &scene->lights[i], 1);
        }
    }
