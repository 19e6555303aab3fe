// mutant: light that grazes the surface by a hair is dropped
// task: lit_color
// caught by: lit-behind
// says: grazes
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 1e-5f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
