// mutant: a hundred lights are enough
// task: shade
// caught by: shade-lights
// says: found
    for (int i = 0; i < min(n_lights, 100); i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
