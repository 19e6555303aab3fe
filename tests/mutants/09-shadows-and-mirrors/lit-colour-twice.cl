// mutant: the colour of the material counts twice
// task: lit_color
// caught by: lit-shadow
// says: colour already
    for (int i = 0; i < scene->n_lights; i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += to_float3(material.color) *
                     shade(point, normal, material, scene->lights + i, 1);
        }
    }
