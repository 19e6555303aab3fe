// mutant: the cosine of a long vector, and light that falls
// task: shade
// caught by: shade-lambert
// says: does not fall
    for (int i = 0; i < n_lights; i++) {
        const float3 l = to_float3(lights[i].position) - point;
        const float cosine = fmax(dot(normal, l), 0.0f) / dot(l, l);
        color += material.kd * cosine * to_float3(material.color) * to_float3(lights[i].color);
    }
