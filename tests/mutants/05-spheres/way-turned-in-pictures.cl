// mutant: the way to the light is turned round: no normal need be
// task: shade
// caught by: shade-picture
// says: or the ways to lights, are turned round
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(point - to_float3(light.position));
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
