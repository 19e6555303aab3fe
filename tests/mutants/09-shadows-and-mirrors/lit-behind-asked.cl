// mutant: rays to lights behind the surface
// task: lit_color
// caught by: lit-behind
// says: sent to every light
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (!is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
