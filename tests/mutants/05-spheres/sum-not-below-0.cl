// mutant: negative sums, not negative shares, become 0
// task: shade
// caught by: shade-behind
// says: each negative cosine
    for (int i = 0; i < n_lights; i++) {
        const float cosine = dot(normal, normalize(to_float3(lights[i].position) - point));
        color += material.kd * cosine * to_float3(material.color) * to_float3(lights[i].color);
    }
    color = fmax(color, 0.0f);
