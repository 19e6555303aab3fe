// mutant: a light that gives no red is taken for one that gives nothing
// task: lit_color
// caught by: lit-shadow
// says: found
    for (int i = 0; i < scene->n_lights; i++) {
        const float3 own = shade(point, normal, material, scene->lights + i, 1);
        if (own.x > 0.0f && !is_blocked(shadow_ray(point, scene->lights[i]), scene, work)) {
            color += own;
        }
    }
