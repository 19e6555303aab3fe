// mutant: where a light is before the surface, all of them are asked
// task: lit_color
// caught by: lit-behind
// says: expected at most
    int is_any_before = 0;
    for (int i = 0; i < scene->n_lights; i++) {
        is_any_before |= dot(normal, shadow_ray(point, scene->lights[i]).direction) > 0.0f;
    }
    for (int i = 0; is_any_before && i < scene->n_lights; i++) {
        if (!is_blocked(shadow_ray(point, scene->lights[i]), scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
