// mutant: a black light ends the list
// task: shade
// caught by: shade-lights
// says: found
    for (int i = 0; i < n_lights; i++) {
        const Light light = lights[i];
        if (light.color.x == 0.0f && light.color.y == 0.0f && light.color.z == 0.0f) {
            break;
        }
        const float3 to_light = normalize(to_float3(light.position) - point);
        const float cosine = fmax(0.0f, dot(normal, to_light));
        color += material.kd * cosine * to_float3(material.color) * to_float3(light.color);
    }
