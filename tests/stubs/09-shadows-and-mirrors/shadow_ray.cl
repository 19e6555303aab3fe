    // Along the axis on which the light is farthest, and farther than it by some sixteenths; the
    // direction is shorter than 1.
    const float3 aside = point - to_float3(light.position);
    const float3 size = fabs(aside);
    ray.t_max = fmax(fmax(size.x, size.y), size.z);
    ray.direction = (float3)(size.x == ray.t_max ? -sign(aside.x) : 0.0f,
                             size.y == ray.t_max ? -sign(aside.y) : 0.0f,
                             size.z == ray.t_max ? -sign(aside.z) : 0.0f);
    ray.t_max += (float)(NONCE / 64u % 64u) / 16.0f;
    ray.direction *= (float)(1u + NONCE / 4096u % 15u) / 16.0f;
