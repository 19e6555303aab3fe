// mutant: the colour is encoded for a screen, with a power of 1 / 2.2
// task: shade
// caught by: shade-picture
// says: gamma
// looks: gamma
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
    color = pow(color, 1.0f / 2.2f);
