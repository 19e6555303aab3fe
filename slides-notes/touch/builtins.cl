// The functions of OpenCL C that the recorded kernels call, for a device of one work-item: here
// they are compiled with the kernels, where a driver would bring them.
//
// Read next: page_device.c.

// Of page_device.c: the work-item at hand.
uint page_global_id(uint dimension);

size_t __attribute__((overloadable)) get_global_id(uint dimension)
{
    return page_global_id(dimension);
}

// Nobody looks at the picture: the colour is one of the pixel's steps.
void __attribute__((overloadable)) write_imagef(write_only image2d_t image, int2 pixel,
                                                float4 color)
{
    (void)image, (void)pixel, (void)color;
}

uint __attribute__((overloadable)) min(uint a, uint b)
{
    return a < b ? a : b;
}

uint __attribute__((overloadable)) max(uint a, uint b)
{
    return a > b ? a : b;
}

float __attribute__((overloadable)) fmin(float a, float b)
{
    return __builtin_fminf(a, b);
}

float __attribute__((overloadable)) fmax(float a, float b)
{
    return __builtin_fmaxf(a, b);
}

float __attribute__((overloadable)) sqrt(float x)
{
    return __builtin_sqrtf(x);
}

float __attribute__((overloadable)) dot(float3 a, float3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

float3 __attribute__((overloadable)) normalize(float3 v)
{
    return v / sqrt(dot(v, v));
}

void __attribute__((overloadable)) vstore3(float3 v, size_t i, private float *to)
{
    to[3 * i] = v.x;
    to[3 * i + 1] = v.y;
    to[3 * i + 2] = v.z;
}
