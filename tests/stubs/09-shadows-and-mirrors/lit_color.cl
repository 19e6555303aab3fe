    // As if the surface shone by itself: by its normal and its material, and a little by where it
    // is.
    count_leaf(work);  // so that it shows how often it is called
    const float share = 0.0625f + (float)(NONCE >> 24) / 4096.0f;
    return (0.5f + material.kd) * to_float3(material.color) * (1.0f + normal) + share * point;
