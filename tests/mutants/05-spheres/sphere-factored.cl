// mutant: l . l as a product of sum and difference of |c| and b, which have lost the digits
// task: intersect_sphere
// caught by: sphere-far-small
// says: digits are lost
    const float3 c = (float3)(sphere.x, sphere.y, sphere.z) - ray.origin;
    const float b = dot(c, ray.direction);
    const float distance_to_centre = length(c);
    const float l2 = (distance_to_centre - b) * (distance_to_centre + b);
    const float disc = sphere.radius * sphere.radius - l2;
    return nearest_root(b, disc, sphere.radius, ray.t_min);
