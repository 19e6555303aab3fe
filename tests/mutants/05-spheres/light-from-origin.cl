// mutant: the light's position for the way to it
// task: shade
// caught by: shade-lambert
// says: for the way to it
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position));
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
