// mutant: a light behind the surface ends the loop
// task: lit_color
// caught by: lit-lights
// says: light behind the surface ended
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) <= 0.0f) {
            break;
        }
        if (!is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
