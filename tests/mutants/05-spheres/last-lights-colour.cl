// mutant: every light has the colour of the last
// task: shade
// caught by: shade-lights
// says: the colour of the same one
    for (int i = 0; i < n_lights; i++) {
        const float3 way = normalize(to_float3(lights[i].position) - point);
        const float3 light = to_float3(lights[n_lights - 1].color);
        color += material.kd * fmax(dot(normal, way), 0.0f) * to_float3(material.color) * light;
    }
