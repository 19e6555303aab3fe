    const float reach = fabsf(sphere.radius);
    return sphere.x + reach >= box.min[0] && sphere.x - reach <= box.max[0] &&
           sphere.y + reach >= box.min[1] && sphere.y - reach <= box.max[1] &&
           sphere.z + reach >= box.min[2] && sphere.z - reach <= box.max[2];
