// mutant: the colours are encoded for a screen, with a power of 1 / 2.2
// task: gradient
// caught by: gradient-picture
// says: gamma
// looks: gamma
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float3 color = (float3)((float)x / width, (float)y / height, 0.25f);
    write_imagef(image, (int2)(x, y), (float4)(pow(color, 1.0f / 2.2f), 1.0f));
