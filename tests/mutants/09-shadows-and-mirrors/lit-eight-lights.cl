// mutant: eight lights are enough
// task: lit_color
// caught by: lit-lights
// says: not all of them are asked
    for (int i = 0; i < min(scene->n_lights, 8); i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
