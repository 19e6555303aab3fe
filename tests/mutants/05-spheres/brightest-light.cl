// mutant: the brightest light for the sum
// task: shade
// caught by: shade-lights
// says: brightest
    for (int i = 0; i < n_lights; i++) {
        const float cosine =
            fmax(0.0f, dot(normal, normalize(to_float3(lights[i].position) - point)));
        color = fmax(color,
                     material.kd * cosine * to_float3(material.color) * to_float3(lights[i].color));
    }
