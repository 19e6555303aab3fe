// mutant: the side is asked with the point
// task: lit_color
// caught by: lit-lights
// says: with the point
    const int is_before = dot(point, normal) > 0.0f;
    for (int k = 0; k < scene->n_lights && is_before; k++) {
        const Light light = scene->lights[k];
        if (!is_blocked(shadow_ray(point, light), scene, work)) {
            color += shade(point, normal, material, &scene->lights[k], 1);
        }
    }
