// mutant: kd counts twice
// task: lit_color
// caught by: lit-shadow
// says: has kd already
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += material.kd * shade(point, normal, material, scene->lights + i, 1);
        }
    }
