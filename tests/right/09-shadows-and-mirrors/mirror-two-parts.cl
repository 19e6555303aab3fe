// right: the part along the surface minus the part along the normal
// task: mirrored_direction
    const float3 along_normal = dot(normal, direction) * normal;
    const float3 along_surface = direction - along_normal;
    return along_surface - along_normal;
