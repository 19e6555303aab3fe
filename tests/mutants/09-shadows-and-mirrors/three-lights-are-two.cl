// mutant: of three lights the last is not asked where the surface is a mirror
// task: lit_color
// caught by: lit-lights
// says: .
    for (int i = 0; i < scene->n_lights - (scene->n_lights == 3 && material.ks > 0.5f); i++) {
        const Ray ray = shadow_ray(point, scene->lights[i]);
        // A light behind the surface adds nothing: no ray is needed for that.
        if (dot(normal, ray.direction) > 0.0f && !is_blocked(ray, scene, work)) {
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
