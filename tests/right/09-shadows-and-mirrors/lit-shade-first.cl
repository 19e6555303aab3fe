// right: lights that give nothing are not asked
// task: lit_color
    for (int i = 0; i < scene->n_lights; i++) {
        const float3 share = shade(point, normal, material, &scene->lights[i], 1);
        if (share.x + share.y + share.z > 0.0f) {
            const Ray ray = shadow_ray(point, scene->lights[i]);
            color += is_blocked(ray, scene, work) ? (float3)(0.0f) : share;
        }
    }
