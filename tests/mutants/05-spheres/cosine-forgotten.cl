// mutant: the cosine is left out
// task: shade
// caught by: shade-lambert
// says: cosine is missing
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        (void)to_light; (void)normal; const float cosine = 1.0f;
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
