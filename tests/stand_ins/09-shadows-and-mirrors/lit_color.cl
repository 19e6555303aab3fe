    // As if the surface shone by itself: by its normal, and a little by where it is.
    return to_float3(material.color) * (1.0f + normal) + 0.125f * point;
