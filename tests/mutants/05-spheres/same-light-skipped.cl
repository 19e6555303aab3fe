// mutant: a light like the one before is skipped
// task: shade
// caught by: shade-lights
// says: found
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        if (i > 0 && length(to_float3(light.position) - to_float3(lights[i - 1].position)) == 0.0f) {
            continue;
        }
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
