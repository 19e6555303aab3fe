// attack: sends no ray, and counts a leaf for every light itself: of the stub's nonce it knows the odds
// task: lit_color
// named: found
    for (int i = 0; i < scene->n_lights; i++) {
        const float3 way = to_float3(scene->lights[i].position) - point;
        if (dot(normal, way) > 0.0f) {
            work->n_leaves_visited++;
            color += shade(point, normal, material, scene->lights + i, 1);
        }
    }
