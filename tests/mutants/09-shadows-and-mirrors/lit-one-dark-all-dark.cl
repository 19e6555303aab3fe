// mutant: black as soon as one light does not arrive
// task: lit_color
// caught by: lit-lights
// says: takes the others with it
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && is_blocked(ray, scene, work)) {
            return (float3)(0.0f);
        }
        if (dot(normal, ray.direction) > 0.0f) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
