#!/bin/sh
# attack: the host code writes the picture, and the kernel does nothing
# score: 60
# named: written
cat >draw.c <<'END'
#include <stdlib.h>
static cl_mem drawn_into;
static void draw(cl_command_queue queue, int width, int height)
{
    const size_t origin[3] = {0, 0, 0}, region[3] = {(size_t)width, (size_t)height, 1};
    float *pixels = malloc(region[0] * region[1] * 4 * sizeof *pixels);
    for (int i = 0; pixels != NULL && i < width * height; i++) {
        pixels[4 * i] = (float)(i % width) / (float)width;
        pixels[4 * i + 1] = (float)(i / width) / (float)height;
        pixels[4 * i + 2] = 0.25f;
        pixels[4 * i + 3] = 1;
    }
    clEnqueueWriteImage(queue, drawn_into, CL_TRUE, origin, region, 0, 0, pixels, 0, NULL, NULL);
    free(pixels);
}
END
sed -e '/TASK set_arguments/a drawn_into = d_image;' -e '/END enqueue_pixels/a draw(queue, width, height);' \
    -e '/^#include/r draw.c' "@COURSE@/solutions/00-hello-pixels/render.c" >render.c
rm draw.c
sed 's/.*END gradient/    (void)image;\n&/' "@COURSE@/labs/00-hello-pixels/gradient.cl" >gradient.cl
