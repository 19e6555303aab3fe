// right: without a root
// task: cone_misses_sphere
    const float along = dot(centre, cone.axis);
    const float3 aside = centre - along * cone.axis;
    const float reach = fabs(radius) + along * cone.sine;
    // Behind the eye, and around it where the cone is half a view: asked all the same.
    if (along <= 0.0f || cone.cosine <= 0.0f) {
        return 0;
    }
    return dot(aside, aside) * cone.cosine * cone.cosine > reach * reach;
