    // A square that stands across the ray's way, with sides along x and y.
    const float dx = fabs(sphere.x - ray.origin.x);
    const float dy = fabs(sphere.y - ray.origin.y);
    return dx <= sphere.radius && dy <= sphere.radius ? sphere.z * ray.direction.z + ray.t_min
                                                      : INFINITY;
