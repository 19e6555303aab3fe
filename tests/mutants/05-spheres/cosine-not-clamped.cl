// mutant: a light behind takes light away
// task: shade
// caught by: shade-behind
// says: takes light away
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = dot(normal, to_light);
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
