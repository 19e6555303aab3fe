// mutant: one ray for all lights
// task: lit_color
// caught by: lit-lights
// says: first light.s ray
    if (scene->n_lights == 0) {
        return color;
    }
    const Ray ray = shadow_ray(point, scene->lights[0]);
    for (int i = 0; i < scene->n_lights; i++) {
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
