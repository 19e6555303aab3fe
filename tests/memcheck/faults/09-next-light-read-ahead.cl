// fault: the next light is read ahead of its turn, also behind the last one
// lab: 09-shadows-and-mirrors
// task: lit_color
// says: reads lights
    Light next = scene->lights[0];
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, next);
        next = scene->lights[i + 1];  // HERE
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
