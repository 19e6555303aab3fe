// mutant: only the first light
// task: lit_color
// caught by: lit-lights
// says: first light.s share only
    for (int i = 0; i < min(1, scene->n_lights); i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
