// mutant: the light falls with the square of the distance
// task: shade
// caught by: shade-lambert
// says: square of the distance
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = fmax(0.0f, dot(normal, to_light)) /
                             pown(distance(to_float3(light.position), point), 2);
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
