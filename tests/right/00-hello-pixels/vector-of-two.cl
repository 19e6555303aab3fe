// right: both divisions in one, of vectors
// task: gradient
    const int2 pixel = (int2)(get_global_id(0), get_global_id(1));
    const int2 size = (int2)(width, height);
    if (any(pixel >= size)) {
        return;
    }
    write_imagef(image, pixel, (float4)(convert_float2(pixel) / convert_float2(size), 0.25f, 1.0f));
