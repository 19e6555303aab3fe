// mutant: the sum is cut at 1
// task: lit_color
// caught by: lit-lights
// says: cut at 1
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
    color = fmin(color, 1.0f);
