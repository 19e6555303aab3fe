// mutant: a ray also to lights that are only just behind the surface
// task: lit_color
// caught by: lit-behind
// says: none for a light behind
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > -1e-3f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
