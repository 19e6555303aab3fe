// right: one channel after the other
// task: shade
    for (int i = 0; i < n_lights; i++) {
        const Vec3 place = lights[i].position;
        const float3 way =
            normalize((float3)(place.x - point.x, place.y - point.y, place.z - point.z));
        const float cosine = clamp(dot(way, normal), 0.0f, 1.0f);
        color.x += cosine * lights[i].color.x * material.color.x * material.kd;
        color.y += cosine * lights[i].color.y * material.color.y * material.kd;
        color.z += cosine * lights[i].color.z * material.color.z * material.kd;
    }
