// What stands before each program's text when it is compiled to native code: an image is memory of
// the host's (Pixels of native_cl.h). OpenCL C's own image types have no size and no address.
#ifndef NATIVE_KERNELS_H
#define NATIVE_KERNELS_H

typedef struct NativePixels {
    global float4 *pixels;
    int width;
    int height;
} NativePixels;
typedef global const NativePixels *NativeImage;

#define image2d_t NativeImage
#define write_only
#define __write_only

#define OVERLOADABLE __attribute__((overloadable))
void OVERLOADABLE write_imagef(NativeImage image, int2 place, float4 color);
int OVERLOADABLE get_image_width(NativeImage image);
int OVERLOADABLE get_image_height(NativeImage image);
int2 OVERLOADABLE get_image_dim(NativeImage image);

#endif
