// mutant: a highlight with ks is added
// task: shade
// caught by: shade-lambert
// says: highlight
    for (int i = 0; i < n_lights; i++) {
        const float cosine =
            fmax(0.0f, dot(normal, normalize(to_float3(lights[i].position) - point)));
        color += material.kd * cosine * to_float3(material.color) * to_float3(lights[i].color);
        color += material.ks * pow(cosine, fmax(material.shine, 1.0f)) * to_float3(lights[i].color);
    }
