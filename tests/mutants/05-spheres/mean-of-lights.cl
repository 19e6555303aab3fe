// mutant: the mean of the lights
// task: shade
// caught by: shade-lights
// says: divided by the number
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
    color /= (float)max(n_lights, 1);
