// OpenCL C's functions for kernels that are compiled to native code: those that the course's
// kernels, probes and known answers call. One that is missing here is named when a program that
// calls it is built.
#include "kernels.h"

// ---- Where a work-item is: the numbers are those of launch.c ------------------------------------

size_t native_item(uint what, uint dimension);
#define ITEM(function, what)                                                                       \
    size_t OVERLOADABLE function(uint dimension)                                                   \
    {                                                                                              \
        return native_item(what, dimension);                                                       \
    }
ITEM(get_global_id, 0)
ITEM(get_local_id, 1)
ITEM(get_group_id, 2)
ITEM(get_global_size, 3)
ITEM(get_local_size, 4)

// ---- Of numbers ---------------------------------------------------------------------------------

// From C's library.
float sqrtf(float x);
float fabsf(float x);
float floorf(float x);
float ceilf(float x);
float rintf(float x);
float powf(float x, float y);
float atan2f(float y, float x);
float sinf(float x);
float cosf(float x);
float tanf(float x);
float fmaf(float x, float y, float z);
float fmaxf(float x, float y);
float fminf(float x, float y);
float copysignf(float x, float y);
float nextafterf(float x, float y);

#define OF_ONE(type, function, result)                                                             \
    type OVERLOADABLE function(type x)                                                             \
    {                                                                                              \
        return result;                                                                             \
    }
#define OF_TWO(type, function, result)                                                             \
    type OVERLOADABLE function(type x, type y)                                                     \
    {                                                                                              \
        return result;                                                                             \
    }
#define OF_THREE(type, function, result)                                                           \
    type OVERLOADABLE function(type x, type y, type z)                                             \
    {                                                                                              \
        return result;                                                                             \
    }

OF_ONE(float, sqrt, sqrtf(x))
OF_ONE(float, fabs, fabsf(x))
OF_ONE(float, floor, floorf(x))
OF_ONE(float, ceil, ceilf(x))
OF_ONE(float, rint, rintf(x))
OF_ONE(float, sin, sinf(x))
OF_ONE(float, cos, cosf(x))
OF_ONE(float, tan, tanf(x))
OF_ONE(float, sign, x > 0 ? 1.0f : x < 0 ? -1.0f : x == 0 ? x : 0.0f)
OF_TWO(float, fmax, fmaxf(x, y))
OF_TWO(float, fmin, fminf(x, y))
OF_TWO(float, pow, powf(x, y))
OF_TWO(float, atan2, atan2f(x, y))
OF_TWO(float, copysign, copysignf(x, y))
OF_TWO(float, nextafter, nextafterf(x, y))
OF_THREE(float, fma, fmaf(x, y, z))
OF_THREE(float, mad, x *y + z)
OF_THREE(float, mix, x + (y - x) * z)
OF_THREE(float, clamp, fminf(fmaxf(x, y), z))
#define MAX_AND_MIN(type)                                                                          \
    OF_TWO(type, max, x < y ? y : x)                                                               \
    OF_TWO(type, min, y < x ? y : x)
MAX_AND_MIN(float)
MAX_AND_MIN(int)
MAX_AND_MIN(uint)
MAX_AND_MIN(long)
MAX_AND_MIN(ulong)
OF_THREE(int, clamp, min(max(x, y), z))
OF_THREE(uint, clamp, min(max(x, y), z))
OF_THREE(int, select, z ? y : x)

uint OVERLOADABLE abs(int x)
{
    return x < 0 ? -(uint)x : (uint)x;
}
float OVERLOADABLE pown(float x, int n)
{
    return powf(x, n);
}
float OVERLOADABLE select(float x, float y, int is_second)
{
    return is_second ? y : x;
}
int OVERLOADABLE isnan(float x)
{
    return x != x;
}
int OVERLOADABLE isinf(float x)
{
    return fabsf(x) == INFINITY;
}
int OVERLOADABLE signbit(float x)
{
    return as_uint(x) >> 31;
}
int OVERLOADABLE islessequal(float x, float y)
{
    return x <= y;
}

// ---- Of vectors, number by number ---------------------------------------------------------------

#define EACH(vector, n, function, parameters, result)                                              \
    vector OVERLOADABLE function parameters                                                        \
    {                                                                                              \
        vector all;                                                                                \
        for (int i = 0; i < n; i++) {                                                              \
            all[i] = result;                                                                       \
        }                                                                                          \
        return all;                                                                                \
    }
#define OF_VECTORS(n)                                                                              \
    EACH(float##n, n, fabs, (float##n x), fabs(x[i]))                                              \
    EACH(float##n, n, sqrt, (float##n x), sqrt(x[i]))                                              \
    EACH(float##n, n, floor, (float##n x), floor(x[i]))                                            \
    EACH(float##n, n, rint, (float##n x), rint(x[i]))                                              \
    EACH(float##n, n, fmax, (float##n x, float##n y), fmax(x[i], y[i]))                            \
    EACH(float##n, n, fmin, (float##n x, float##n y), fmin(x[i], y[i]))                            \
    EACH(float##n, n, fmax, (float##n x, float y), fmax(x[i], y))                                  \
    EACH(float##n, n, fmin, (float##n x, float y), fmin(x[i], y))                                  \
    EACH(float##n, n, max, (float##n x, float##n y), max(x[i], y[i]))                              \
    EACH(float##n, n, min, (float##n x, float##n y), min(x[i], y[i]))                              \
    EACH(float##n, n, max, (float##n x, float y), max(x[i], y))                                    \
    EACH(float##n, n, min, (float##n x, float y), min(x[i], y))                                    \
    EACH(float##n, n, pow, (float##n x, float##n y), pow(x[i], y[i]))                              \
    EACH(float##n, n, nextafter, (float##n x, float##n y), nextafter(x[i], y[i]))                  \
    EACH(float##n, n, copysign, (float##n x, float##n y), copysign(x[i], y[i]))                    \
    EACH(float##n, n, mad, (float##n x, float##n y, float##n z), mad(x[i], y[i], z[i]))            \
    EACH(float##n, n, fma, (float##n x, float##n y, float##n z), fma(x[i], y[i], z[i]))            \
    EACH(float##n, n, mix, (float##n x, float##n y, float z), mix(x[i], y[i], z))                  \
    EACH(float##n, n, clamp, (float##n x, float y, float z), clamp(x[i], y, z))                    \
    EACH(float##n, n, clamp, (float##n x, float##n y, float##n z), clamp(x[i], y[i], z[i]))        \
    EACH(float##n, n, convert_float##n, (int##n x), (float)x[i])                                   \
    EACH(float##n, n, convert_float##n, (uint##n x), (float)x[i])                                  \
    EACH(int##n, n, convert_int##n, (float##n x), (int)x[i])                                       \
    EACH(float##n, n, select, (float##n x, float##n y, int##n z), z[i] < 0 ? y[i] : x[i])          \
    EACH(int##n, n, select, (int##n x, int##n y, int##n z), z[i] < 0 ? y[i] : x[i])                \
    EACH(uint##n, n, select, (uint##n x, uint##n y, int##n z), z[i] < 0 ? y[i] : x[i])             \
    EACH(uint##n, n, convert_uint##n, (float##n x), (uint)x[i])                                    \
    EACH(uint##n, n, convert_uint##n, (int##n x), (uint)x[i])                                      \
    EACH(int##n, n, convert_int##n, (uint##n x), (int)x[i])                                        \
    EACH(int##n, n, max, (int##n x, int##n y), max(x[i], y[i]))                                    \
    EACH(int##n, n, min, (int##n x, int##n y), min(x[i], y[i]))                                    \
    EACH(uint##n, n, max, (uint##n x, uint##n y), max(x[i], y[i]))                                 \
    EACH(uint##n, n, min, (uint##n x, uint##n y), min(x[i], y[i]))                                 \
    EACH(int##n, n, max, (int##n x, int y), max(x[i], y))                                          \
    EACH(int##n, n, min, (int##n x, int y), min(x[i], y))                                          \
    EACH(uint##n, n, max, (uint##n x, uint y), max(x[i], y))                                       \
    EACH(uint##n, n, min, (uint##n x, uint y), min(x[i], y))                                       \
    EACH(int##n, n, isnan, (float##n x), -(x[i] != x[i]))                                          \
    EACH(int##n, n, islessequal, (float##n x, float##n y), -(x[i] <= y[i]))                        \
    int OVERLOADABLE any(int##n x)                                                                 \
    {                                                                                              \
        int is_set = 0;                                                                            \
        for (int i = 0; i < n; i++) {                                                              \
            is_set |= x[i] < 0;                                                                    \
        }                                                                                          \
        return is_set;                                                                             \
    }                                                                                              \
    int OVERLOADABLE all(int##n x)                                                                 \
    {                                                                                              \
        int is_set = 1;                                                                            \
        for (int i = 0; i < n; i++) {                                                              \
            is_set &= x[i] < 0;                                                                    \
        }                                                                                          \
        return is_set;                                                                             \
    }
OF_VECTORS(2)
OF_VECTORS(3)
OF_VECTORS(4)
OF_VECTORS(8)
OF_VECTORS(16)

float OVERLOADABLE convert_float(int x)
{
    return (float)x;
}
float OVERLOADABLE convert_float(uint x)
{
    return (float)x;
}
int OVERLOADABLE convert_int_rtz(float x)
{
    return (int)x;
}

// ---- Of points and directions -------------------------------------------------------------------

#define OF_POINTS(n)                                                                               \
    float OVERLOADABLE dot(float##n x, float##n y)                                                 \
    {                                                                                              \
        float sum = x[0] * y[0];                                                                   \
        for (int i = 1; i < n; i++) {                                                              \
            sum += x[i] * y[i];                                                                    \
        }                                                                                          \
        return sum;                                                                                \
    }                                                                                              \
    OF_LENGTH(float##n, length, (float##n x), sqrt(dot(x, x)))                                     \
    OF_LENGTH(float##n, distance, (float##n x, float##n y), length(x - y))                         \
    float##n OVERLOADABLE normalize(float##n x)                                                    \
    {                                                                                              \
        return x / length(x);                                                                      \
    }
#define OF_LENGTH(vector, function, parameters, result)                                            \
    float OVERLOADABLE function parameters                                                         \
    {                                                                                              \
        return result;                                                                             \
    }
OF_POINTS(2)
OF_POINTS(3)
OF_POINTS(4)

float3 OVERLOADABLE cross(float3 x, float3 y)
{
    return x.yzx * y.zxy - x.zxy * y.yzx;
}

// ---- Memory -------------------------------------------------------------------------------------

// Work-items run one after the other.
uint OVERLOADABLE atomic_inc(volatile global uint *number)
{
    return (*number)++;
}
uint OVERLOADABLE atomic_xchg(volatile global uint *number, uint value)
{
    const uint before = *number;
    *number = value;
    return before;
}

// Vectors from and to numbers that lie one after the other.
#define LOAD(type, n, space)                                                                       \
    type##n OVERLOADABLE vload##n(size_t place, space const type *numbers)                         \
    {                                                                                              \
        type##n all;                                                                               \
        for (int i = 0; i < n; i++) {                                                              \
            all[i] = numbers[place * n + i];                                                       \
        }                                                                                          \
        return all;                                                                                \
    }
#define STORE(type, n, space)                                                                      \
    void OVERLOADABLE vstore##n(type##n all, size_t place, space type *numbers)                    \
    {                                                                                              \
        for (int i = 0; i < n; i++) {                                                              \
            numbers[place * n + i] = all[i];                                                       \
        }                                                                                          \
    }
#define LOAD_AND_STORE(type, n)                                                                    \
    LOAD(type, n, global)                                                                          \
    LOAD(type, n, private)                                                                         \
    LOAD(type, n, constant)                                                                        \
    STORE(type, n, global)                                                                         \
    STORE(type, n, private)
#define LOADS_AND_STORES(type)                                                                     \
    LOAD_AND_STORE(type, 2)                                                                        \
    LOAD_AND_STORE(type, 3)                                                                        \
    LOAD_AND_STORE(type, 4)                                                                        \
    LOAD_AND_STORE(type, 8)                                                                        \
    LOAD_AND_STORE(type, 16)
LOADS_AND_STORES(float)
LOADS_AND_STORES(int)
LOADS_AND_STORES(uint)

// The memory sanitizer reports what is used; a colour is used where it is drawn.
#if __has_feature(memory_sanitizer)
void __msan_check_mem_is_initialized(const void *bytes, size_t n_bytes);
#define CHECK_IS_SET(value) __msan_check_mem_is_initialized(&(value), sizeof(value))
#else
#define CHECK_IS_SET(value)
#endif

// A pixel beside the image is dropped, as drivers do.
void OVERLOADABLE write_imagef(NativeImage image, int2 place, float4 color)
{
    CHECK_IS_SET(color);
    if (place.x >= 0 && place.y >= 0 && place.x < image->width && place.y < image->height) {
        image->pixels[(size_t)place.y * (size_t)image->width + (size_t)place.x] = color;
    }
}
int OVERLOADABLE get_image_width(NativeImage image)
{
    return image->width;
}
int OVERLOADABLE get_image_height(NativeImage image)
{
    return image->height;
}
int2 OVERLOADABLE get_image_dim(NativeImage image)
{
    return (int2)(image->width, image->height);
}
