// Lab 00: the smallest picture a kernel can draw, one work-item per pixel.
//
// Flow: [no scene] -> buffers -> KERNEL -> image. Started by render.c.

// Write a colour that shows where the pixel is: red grows to the right, green grows downwards.
//   width, height   the picture, pixels
//   image           RGBA float, width x height; row 0 is the top row
kernel void gradient(int width, int height, write_only image2d_t image)
{
    // TASK gradient: red is x / width, green is y / height, blue is 0.25, alpha is 1. Spare
    // work-items, outside the picture, write nothing.
    //> (void)width, (void)height, (void)image;
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    const float red = (float)x / width;
    const float green = (float)y / height;
    write_imagef(image, (int2)(x, y), (float4)(red, green, 0.25f, 1.0f));
    // END gradient
}
