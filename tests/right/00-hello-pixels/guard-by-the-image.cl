// right: the image knows how large the picture is
// task: gradient
    const int2 pixel = {get_global_id(0), get_global_id(1)};
    if (pixel.x >= get_image_width(image) || pixel.y >= get_image_height(image)) {
        return;
    }
    const float2 share = {(float)pixel.x / width, (float)pixel.y / height};
    write_imagef(image, pixel, (float4)(share, 0.25f, 1.0f));
