// right: lights behind are skipped; the material's part comes last
// task: shade
    float3 light_sum = (float3)(0.0f);
    for (int i = n_lights; i-- > 0;) {
        const float3 way = to_float3(lights[i].position) - point;
        const float along = dot(way, normal);
        if (along <= 0.0f) {
            continue;
        }
        light_sum += to_float3(lights[i].color) * (along / length(way));
    }
    color = light_sum * to_float3(material.color) * material.kd;
