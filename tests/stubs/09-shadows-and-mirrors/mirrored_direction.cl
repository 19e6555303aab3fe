    // Every ray leaves along the normal, but for a lean that is the same everywhere.
    const float3 lean = (float3)((float)(NONCE % 16u), (float)(NONCE / 16u % 16u), (float)(NONCE / 256u % 16u));
    return normalize(normal + (lean - 7.5f) / 64.0f);
