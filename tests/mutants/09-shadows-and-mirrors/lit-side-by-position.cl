// mutant: the light's position for the way to it
// task: lit_color
// caught by: lit-lights
// says: light.s position
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, to_float3(scene->lights[i].position)) > 0.0f &&
            !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
