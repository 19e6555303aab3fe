// mutant: dark lights are left out
// task: lit_color
// caught by: lit-shadow
// says: a dark light
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && length(to_float3(scene->lights[i].color)) > 0.01f &&
            !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
