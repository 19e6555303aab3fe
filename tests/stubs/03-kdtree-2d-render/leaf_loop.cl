    // Which leaf this is, and whose pixel.
    (void)circles, (void)mapNode2Circles;
    color = (float4)(id, x, y, 1.0f);
