// mutant: the material's colour is cut at 1
// task: shade
// caught by: shade-lambert
// says: found
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * fmin(to_float3(material.color), 1.0f) *
                 to_float3(light.color);
    }
