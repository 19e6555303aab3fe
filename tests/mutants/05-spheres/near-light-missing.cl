// mutant: a light that is closer than 1e-4 adds nothing
// task: shade
// caught by: shade-lambert
// says: found
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = to_float3(light.position) - point;
        if (length(to_light) > 1e-4f) {
            const float cosine = fmax(0.0f, dot(normal, normalize(to_light)));
            color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
        }
    }
