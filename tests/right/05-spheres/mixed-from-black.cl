// right: mix() from black by the cosine, and fast_normalize() for the way to the light
// task: shade
    for (int i = 0; i < n_lights; i++) {
        const float3 to_light = fast_normalize(to_float3(lights[i].position) - point);
        const float3 lit = material.kd * to_float3(material.color) * to_float3(lights[i].color);
        color += mix((float3)(0.0f), lit, (float3)(clamp(dot(normal, to_light), 0.0f, 1.0f)));
    }
