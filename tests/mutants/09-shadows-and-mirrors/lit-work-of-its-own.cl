// mutant: a Work of its own for each ray
// task: lit_color
// caught by: lit-behind
// says: passed on
    for (int i = 0; i < scene->n_lights; i++) {
        Work own = {0, 0, 0, 0};
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, &own)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
