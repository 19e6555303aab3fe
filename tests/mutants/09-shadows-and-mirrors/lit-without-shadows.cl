// mutant: light is added although something stands between
// task: lit_color
// caught by: lit-shadow
// says: although something stands between
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
