// Lab 04: the ray from the eye through a pixel. Labs 05 and 07 start every picture with it.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by draw_directions.cl, and by the kernels of
// labs 05 and 07.
#include "camera.h"
#include "ray.h"

// The middle of pixel (x, y) on the display, seen from the eye: x along the camera's right, y along
// its up, z along its forward. The display is at distance 1, so z is 1.
//   width, height   the picture, pixels; pixels are squares; row 0 is the top row
//   fov             the display's width (its distance is 1)
float3 pixel_on_display(int x, int y, int width, int height, float fov)
{
    // TASK pixel_on_display: the point in the middle of the pixel. x grows from -fov / 2 at the
    // left border of the display to fov / 2 at its right border; y grows upwards. Pixels are
    // squares.
    //> (void)x, (void)y, (void)width, (void)height, (void)fov;
    //> return (float3)(0.0f, 0.0f, 1.0f);
    const float pixel_size = fov / width;
    const float right = (x + 0.5f - 0.5f * width) * pixel_size;
    const float up = (0.5f * height - (y + 0.5f)) * pixel_size;
    return (float3)(right, up, 1.0f);
    // END pixel_on_display
}

// The ray from the eye through the middle of pixel (x, y), in the scene's coordinates. It starts at
// the eye and has no end; its direction is a unit vector.
//   camera   see camera.h
// Source: lecture, slide "Viewing".
Ray primary_ray(int x, int y, int width, int height, Camera camera)
{
    Ray ray;
    // TASK primary_ray: apply the view transform: turn the point that pixel_on_display() returns
    // from the camera's axes to the scene's. Fill in all four parts of the ray.
    //> (void)x, (void)y, (void)width, (void)height, (void)camera;
    //> ray.origin = (float3)(0.0f);
    //> ray.direction = (float3)(0.0f);
    //> ray.t_min = 0.0f;
    //> ray.t_max = 0.0f;
    const float3 pixel = pixel_on_display(x, y, width, height, camera.fov);
    const float3 direction = pixel.x * to_float3(camera.right) + pixel.y * to_float3(camera.up) +
                             pixel.z * to_float3(camera.forward);
    ray.origin = to_float3(camera.eye);
    ray.direction = normalize(direction);
    ray.t_min = 0.0f;
    ray.t_max = INFINITY;
    // END primary_ray
    return ray;
}
