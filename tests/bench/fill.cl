// Bench: a kernel that only writes the picture. No renderer that draws into an image can be faster,
// so its time is the floor under the others. Started by bench2d.c.

// Make every pixel the background.
//   width, height   the picture, pixels; work-items outside it write nothing
kernel void fill(int width, int height, write_only image2d_t image)
{
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    write_imagef(image, (int2)(x, y), (float4)(0.0f));
}
