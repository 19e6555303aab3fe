// right: turned round before it is made a unit vector
// task: surface_normal
    float3 away = point - (float3)(sphere.x, sphere.y, sphere.z);
    if (dot(away, direction) > 0.0f) {
        away = -away;
    }
    return away / length(away);
