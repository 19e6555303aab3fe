// mutant: the last of several lights is left out
// task: lit_color
// caught by: lit-lights
// says: last light is not asked
    for (int i = 0; i < max(1, scene->n_lights - 1) && i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
