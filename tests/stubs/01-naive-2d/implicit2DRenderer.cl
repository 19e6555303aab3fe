    (void)circles;
    color = (float4)(x, y, n_circles, 1.0f);
