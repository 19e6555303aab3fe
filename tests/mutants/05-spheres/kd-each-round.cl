// mutant: the sum so far is multiplied by kd, too
// task: shade
// caught by: shade-lights
// says: kd with each
    for (int i = 0; i < n_lights; i++) {
        const float cosine =
            fmax(0.0f, dot(normal, normalize(to_float3(lights[i].position) - point)));
        color += cosine * to_float3(material.color) * to_float3(lights[i].color);
        color *= material.kd;
    }
