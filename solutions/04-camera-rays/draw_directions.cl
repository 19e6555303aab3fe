// Lab 04: a picture of the rays themselves: directions as colours.
//
// Flow: scene -> buffers -> KERNEL -> image. Started by main.c.
#include "primary_ray.cl"

// Draw each pixel in the colour of its ray's direction, one work-item a pixel.
//   width, height   the picture, pixels; work-items outside it write nothing
//   image           RGBA float, at least width x height; row 0 is the top row
kernel void draw_directions(Camera camera, int width, int height, write_only image2d_t image)
{
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    // Work-items that fill up the last work-groups are outside the picture.
    if (x >= width || y >= height) {
        return;
    }
    float3 color = (float3)(0.0f);
    // TASK direction_color: map the components of the direction, from -1 to 1, evenly to those of a
    // colour, from 0 to 1. x is red, y is green, z is blue.
    //> (void)camera;
    const Ray ray = primary_ray(x, y, width, height, camera);
    color = 0.5f * ray.direction + 0.5f;
    // END direction_color
    write_imagef(image, (int2)(x, y), (float4)(color, 1.0f));
}
