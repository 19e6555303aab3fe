// right: the centre's foot on the ray, as a point in space
// task: intersect_sphere
    const float3 centre = (float3)(sphere.x, sphere.y, sphere.z);
    const float3 to_eye = ray.origin - centre;
    const float along = -dot(to_eye, ray.direction);
    const float3 foot = to_eye + along * ray.direction;
    return nearest_root(along, sphere.radius * sphere.radius - dot(foot, foot), sphere.radius,
                        ray.t_min);
