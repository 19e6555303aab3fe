// mutant: without a light the first one shines all the same
// task: shade
// caught by: shade-lights
// says: 0 lights
    int i = 0;
    do {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    } while (++i < n_lights);
