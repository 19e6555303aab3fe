// mutant: the way to the light is turned round
// task: shade
// caught by: shade-behind
// says: from the light to the point
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(point - to_float3(light.position));
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
