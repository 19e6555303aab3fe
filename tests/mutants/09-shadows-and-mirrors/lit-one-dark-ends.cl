// mutant: a light that does not arrive ends the loop
// task: lit_color
// caught by: lit-lights
// says: no other one is asked
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) <= 0.0f) {
            continue;
        }
        if (is_blocked(ray, scene, work)) {
            break;
        }
        color += shade(point, normal, material, scene->lights + i, 1);
    }
