// mutant: the first light behind the surface ends the loop
// task: shade
// caught by: shade-lights
// says: ended the loop
    for (int i = 0; i < n_lights; i++) {
        const float cosine = dot(normal, normalize(to_float3(lights[i].position) - point));
        if (cosine <= 0.0f) {
            break;
        }
        color += material.kd * cosine * to_float3(material.color) * to_float3(lights[i].color);
    }
