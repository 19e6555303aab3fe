// mutant: each light's colour is cut at 1
// task: shade
// caught by: shade-lights
// says: each light was cut
    for (int i = 0; i < n_lights; i++) {
        const float cosine =
            fmax(0.0f, dot(normal, normalize(to_float3(lights[i].position) - point)));
        color += material.kd * cosine * to_float3(material.color) *
                 fmin(to_float3(lights[i].color), 1.0f);
    }
