// mutant: surfaces that scatter little are not lit
// task: lit_color
// caught by: lit-shadow
// says: a surface that scatters little
    for (int i = 0; i < scene->n_lights && material.kd > 0.01f; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
