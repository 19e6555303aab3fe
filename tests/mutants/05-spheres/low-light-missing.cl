// mutant: a light that grazes by 1e-5 adds nothing
// task: shade
// caught by: shade-lambert
// says: found
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = dot(normal, to_light);
        if (cosine > 1.6e-5f) {
            color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
        }
    }
