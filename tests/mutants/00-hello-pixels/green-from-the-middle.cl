// mutant: only green is taken at the pixel's middle
// task: gradient
// caught by: gradient-picture
// says: shifted by half a pixel
// looks: shifted-half
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float green = (y + 0.5f) / height;
    write_imagef(image, (int2)(x, y), (float4)((float)x / width, green, 0.25f, 1.0f));
