// mutant: the light's red is its brightness
// task: shade
// caught by: shade-lambert
// says: red was taken
    for (int i = 0; i < n_lights; i++) {
        const float cosine =
            fmax(0.0f, dot(normal, normalize(to_float3(lights[i].position) - point)));
        color += material.kd * cosine * lights[i].color.x * to_float3(material.color);
    }
