    // By lot, which the ray's length draws: on the judge's grid it is a whole number of sixteenths.
    return (int)(((((uint)(16.0f * ray.t_max) * 2654435769u) ^ LOT) * 2246822519u) >> 31);
