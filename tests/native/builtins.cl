// OpenCL C's functions for kernels that are compiled to native code. Those of the course's kernels,
// probes and known answers are here, and all that an answer to a lab may call besides. One that is
// missing is named when a program that calls it is built.
#include "kernels.h"

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
// How wide vectors are handed over depends on the processor that the compiler is told of: kernels'
// compiler is told of the same.
#pragma clang diagnostic ignored "-Wpsabi"

// ---- Where a work-item is: the numbers are those of launch.c ------------------------------------

size_t native_item(uint what, uint dimension);
#define ITEM(function, result)                                                                     \
    size_t OVERLOADABLE function(uint dimension)                                                   \
    {                                                                                              \
        return result;                                                                             \
    }
ITEM(get_global_id, native_item(0, dimension))
ITEM(get_local_id, native_item(1, dimension))
ITEM(get_group_id, native_item(2, dimension))
ITEM(get_global_size, native_item(3, dimension))
ITEM(get_local_size, native_item(4, dimension))
ITEM(get_num_groups, get_global_size(dimension) / get_local_size(dimension))
ITEM(get_global_offset, get_global_id(dimension) - get_local_id(dimension) -
                            get_group_id(dimension) * get_local_size(dimension))

// ---- A function of numbers, and the same of vectors, number by number ---------------------------

#define FOR_WIDTHS(of, ...)                                                                        \
    of(2, __VA_ARGS__) of(3, __VA_ARGS__) of(4, __VA_ARGS__) of(8, __VA_ARGS__) of(16, __VA_ARGS__)
#define EACH(vector, n, function, parameters, result)                                              \
    vector OVERLOADABLE function parameters                                                        \
    {                                                                                              \
        vector all;                                                                                \
        for (int i = 0; i < n; i++) {                                                              \
            all[i] = result;                                                                       \
        }                                                                                          \
        return all;                                                                                \
    }
#define SINGLE(type, function, parameters, result)                                                 \
    type OVERLOADABLE function parameters                                                          \
    {                                                                                              \
        return result;                                                                             \
    }

#define EACH_1(n, to, type, f) EACH(to##n, n, f, (type##n x), f(x[i]))
#define EACH_2(n, to, type, f) EACH(to##n, n, f, (type##n x, type##n y), f(x[i], y[i]))
#define EACH_3(n, to, type, f)                                                                     \
    EACH(to##n, n, f, (type##n x, type##n y, type##n z), f(x[i], y[i], z[i]))
#define EACH_1_SCALAR(n, type, f) EACH(type##n, n, f, (type##n x, type y), f(x[i], y))
#define SCALAR_EACH_1(n, type, f) EACH(type##n, n, f, (type x, type##n y), f(x, y[i]))
#define EACH_1_SCALARS(n, type, f) EACH(type##n, n, f, (type##n x, type y, type z), f(x[i], y, z))
#define EACH_2_SCALAR(n, type, f)                                                                  \
    EACH(type##n, n, f, (type##n x, type##n y, type z), f(x[i], y[i], z))
#define SCALARS_EACH_1(n, type, f) EACH(type##n, n, f, (type x, type y, type##n z), f(x, y, z[i]))

#define OF_1(to, type, f, result)                                                                  \
    SINGLE(to, f, (type x), result)                                                                \
    FOR_WIDTHS(EACH_1, to, type, f)
#define OF_2(type, f, result)                                                                      \
    SINGLE(type, f, (type x, type y), result)                                                      \
    FOR_WIDTHS(EACH_2, type, type, f)
#define OF_3(type, f, result)                                                                      \
    SINGLE(type, f, (type x, type y, type z), result)                                              \
    FOR_WIDTHS(EACH_3, type, type, f)

// ---- Numbers with a fraction --------------------------------------------------------------------

// From C's library, under names of our own: C's are those of OpenCL.
#define FROM_C(f)                                                                                  \
    float c_##f(float x) __asm__(#f "f");                                                          \
    double c_##f##_d(double x) __asm__(#f);                                                        \
    OF_1(float, float, f, c_##f(x))                                                                \
    OF_1(double, double, f, c_##f##_d(x))
#define FROM_C_2(f)                                                                                \
    float c_##f(float x, float y) __asm__(#f "f");                                                 \
    double c_##f##_d(double x, double y) __asm__(#f);                                              \
    OF_2(float, f, c_##f(x, y))                                                                    \
    OF_2(double, f, c_##f##_d(x, y))
FROM_C(sqrt)
FROM_C(cbrt)
FROM_C(fabs)
FROM_C(floor)
FROM_C(ceil)
FROM_C(rint)
FROM_C(round)
FROM_C(trunc)
FROM_C(sin)
FROM_C(cos)
FROM_C(tan)
FROM_C(asin)
FROM_C(acos)
FROM_C(atan)
FROM_C(sinh)
FROM_C(cosh)
FROM_C(tanh)
FROM_C(exp)
FROM_C(exp2)
FROM_C(exp10)
FROM_C(expm1)
FROM_C(log)
FROM_C(log2)
FROM_C(log10)
FROM_C(log1p)
FROM_C_2(fmax)
FROM_C_2(fmin)
FROM_C_2(pow)
FROM_C_2(atan2)
FROM_C_2(copysign)
FROM_C_2(nextafter)
FROM_C_2(fmod)
FROM_C_2(remainder)
FROM_C_2(hypot)
FROM_C_2(fdim)

float c_fma(float x, float y, float z) __asm__("fmaf");
double c_fma_d(double x, double y, double z) __asm__("fma");
OF_3(float, fma, c_fma(x, y, z))
OF_3(double, fma, c_fma_d(x, y, z))

#define OF_FRACTIONS(type)                                                                         \
    OF_1(type, type, sign, x > 0 ? (type)1 : x < 0 ? (type) - 1 : x == 0 ? x : (type)0)            \
    OF_1(type, type, rsqrt, 1 / sqrt(x))                                                           \
    OF_1(type, type, degrees, x *(type)(180 / M_PI))                                               \
    OF_1(type, type, radians, x *(type)(M_PI / 180))                                               \
    OF_2(type, powr, pow(x, y))                                                                    \
    OF_2(type, step, y < x ? (type)0 : (type)1)                                                    \
    OF_2(type, max, x < y ? y : x)                                                                 \
    OF_2(type, min, y < x ? y : x)                                                                 \
    OF_3(type, mad, x *y + z)                                                                      \
    OF_3(type, mix, x + (y - x) * z)                                                               \
    OF_3(type, clamp, fmin(fmax(x, y), z))                                                         \
    OF_3(type, smoothstep, smooth(clamp((z - x) / (y - x), (type)0, (type)1)))                     \
    FOR_WIDTHS(EACH_1_SCALAR, type, fmax)                                                          \
    FOR_WIDTHS(EACH_1_SCALAR, type, fmin)                                                          \
    FOR_WIDTHS(EACH_1_SCALAR, type, max)                                                           \
    FOR_WIDTHS(EACH_1_SCALAR, type, min)                                                           \
    FOR_WIDTHS(SCALAR_EACH_1, type, step)                                                          \
    FOR_WIDTHS(EACH_1_SCALARS, type, clamp)                                                        \
    FOR_WIDTHS(EACH_2_SCALAR, type, mix)                                                           \
    FOR_WIDTHS(SCALARS_EACH_1, type, smoothstep)                                                   \
    SINGLE(type, pown, (type x, int n), pow(x, (type)n))                                           \
    WITH_POINTERS(type, private)                                                                   \
    WITH_POINTERS(type, global)
// The second result goes where a pointer says.
#define WITH_POINTERS(type, space)                                                                 \
    type OVERLOADABLE fract(type x, space type *whole)                                             \
    {                                                                                              \
        *whole = floor(x);                                                                         \
        return fmin(x - floor(x), nextafter((type)1, (type)0));                                    \
    }                                                                                              \
    type OVERLOADABLE modf(type x, space type *whole)                                              \
    {                                                                                              \
        *whole = trunc(x);                                                                         \
        return copysign(isinf(x) ? (type)0 : x - trunc(x), x);                                     \
    }                                                                                              \
    type OVERLOADABLE sincos(type x, space type *cosine)                                           \
    {                                                                                              \
        *cosine = cos(x);                                                                          \
        return sin(x);                                                                             \
    }
SINGLE(float, smooth, (float x), x *x * (3 - 2 * x))
SINGLE(double, smooth, (double x), x *x * (3 - 2 * x))
OF_FRACTIONS(float)
OF_FRACTIONS(double)

// Which may be less exact, and here are not.
#define AS_EXACT(f)                                                                                \
    OF_1(float, float, native_##f, f(x))                                                           \
    OF_1(float, float, half_##f, f(x))
AS_EXACT(sqrt)
AS_EXACT(rsqrt)
AS_EXACT(sin)
AS_EXACT(cos)
AS_EXACT(tan)
AS_EXACT(exp)
AS_EXACT(exp2)
AS_EXACT(exp10)
AS_EXACT(log)
AS_EXACT(log2)
AS_EXACT(log10)
OF_1(float, float, native_recip, 1 / x)
OF_1(float, float, half_recip, 1 / x)
OF_2(float, native_divide, x / y)
OF_2(float, half_divide, x / y)
OF_2(float, native_powr, pow(x, y))
OF_2(float, half_powr, pow(x, y))

// ---- Comparisons: of numbers 1 where they hold, of vectors -1 -----------------------------------

#define EACH_HOLDS_1(n, to, type, f) EACH(to##n, n, f, (type##n x), -f(x[i]))
#define EACH_HOLDS_2(n, to, type, f) EACH(to##n, n, f, (type##n x, type##n y), -f(x[i], y[i]))
#define HOLDS_1(f, condition)                                                                      \
    SINGLE(int, f, (float x), condition)                                                           \
    SINGLE(int, f, (double x), condition)                                                          \
    FOR_WIDTHS(EACH_HOLDS_1, int, float, f)                                                        \
    FOR_WIDTHS(EACH_HOLDS_1, long, double, f)
#define HOLDS_2(f, condition)                                                                      \
    SINGLE(int, f, (float x, float y), condition)                                                  \
    SINGLE(int, f, (double x, double y), condition)                                                \
    FOR_WIDTHS(EACH_HOLDS_2, int, float, f)                                                        \
    FOR_WIDTHS(EACH_HOLDS_2, long, double, f)
HOLDS_1(isnan, x != x)
HOLDS_1(isinf, fabs(x) == INFINITY)
HOLDS_1(isfinite, fabs(x) < INFINITY)
HOLDS_1(isnormal, __builtin_isnormal(x))
HOLDS_1(signbit, copysign(1, x) < 0)
HOLDS_2(isequal, x == y)
HOLDS_2(isnotequal, x != y)
HOLDS_2(isgreater, x > y)
HOLDS_2(isgreaterequal, x >= y)
HOLDS_2(isless, x < y)
HOLDS_2(islessequal, x <= y)
HOLDS_2(islessgreater, x<y || x> y)
HOLDS_2(isordered, x == x && y == y)
HOLDS_2(isunordered, x != x || y != y)

// Of a vector's number the first bit decides, of a number alone whether it is 0.
#define EACH_SELECTED(n, type, mask)                                                               \
    EACH(type##n, n, select, (type##n x, type##n y, mask##n z),                                    \
         z[i] >> (8 * sizeof z[i] - 1) & 1 ? y[i] : x[i])
#define SELECTED(type, mask)                                                                       \
    SINGLE(type, select, (type x, type y, mask z), z != 0 ? y : x)                                 \
    FOR_WIDTHS(EACH_SELECTED, type, mask)
SELECTED(float, int)
SELECTED(float, uint)
SELECTED(double, long)
SELECTED(double, ulong)
SELECTED(char, char)
SELECTED(uchar, uchar)
SELECTED(int, int)
SELECTED(int, uint)
SELECTED(uint, int)
SELECTED(uint, uint)
SELECTED(long, long)
SELECTED(ulong, ulong)

#define ANY_AND_ALL(n, type)                                                                       \
    int OVERLOADABLE any(type##n x)                                                                \
    {                                                                                              \
        int is_set = 0;                                                                            \
        for (int i = 0; i < n; i++) {                                                              \
            is_set |= x[i] < 0;                                                                    \
        }                                                                                          \
        return is_set;                                                                             \
    }                                                                                              \
    int OVERLOADABLE all(type##n x)                                                                \
    {                                                                                              \
        int is_set = 1;                                                                            \
        for (int i = 0; i < n; i++) {                                                              \
            is_set &= x[i] < 0;                                                                    \
        }                                                                                          \
        return is_set;                                                                             \
    }
FOR_WIDTHS(ANY_AND_ALL, char)
FOR_WIDTHS(ANY_AND_ALL, int)
FOR_WIDTHS(ANY_AND_ALL, long)
SINGLE(int, any, (int x), x < 0)
SINGLE(int, all, (int x), x < 0)

// ---- Whole numbers ------------------------------------------------------------------------------

#define OF_WHOLES(type, unsigned_type)                                                             \
    OF_2(type, max, x < y ? y : x)                                                                 \
    OF_2(type, min, y < x ? y : x)                                                                 \
    OF_3(type, clamp, min(max(x, y), z))                                                           \
    FOR_WIDTHS(EACH_1_SCALAR, type, max)                                                           \
    FOR_WIDTHS(EACH_1_SCALAR, type, min)                                                           \
    FOR_WIDTHS(EACH_1_SCALARS, type, clamp)                                                        \
    OF_1(unsigned_type, type, abs, x < 0 ? -(unsigned_type)x : (unsigned_type)x)                   \
    SINGLE(unsigned_type, abs_diff, (type x, type y),                                              \
           x < y ? (unsigned_type)y - (unsigned_type)x : (unsigned_type)x - (unsigned_type)y)      \
    FOR_WIDTHS(EACH_2, unsigned_type, type, abs_diff)                                              \
    OF_2(type, hadd, (x >> 1) + (y >> 1) + (x & y & 1))                                            \
    OF_2(type, rhadd, (x >> 1) + (y >> 1) + ((x | y) & 1))                                         \
    OF_1(type, type, popcount, __builtin_popcountll((unsigned_type)x))                             \
    OF_1(type, type, clz,                                                                          \
         x == 0 ? 8 * sizeof x                                                                     \
                : __builtin_clzll((unsigned_type)x) - 8 * (sizeof(ulong) - sizeof x))
OF_WHOLES(char, uchar)
OF_WHOLES(uchar, uchar)
OF_WHOLES(short, ushort)
OF_WHOLES(ushort, ushort)
OF_WHOLES(int, uint)
OF_WHOLES(uint, uint)
OF_WHOLES(long, ulong)
OF_WHOLES(ulong, ulong)
OF_2(int, mul24, x *y)
OF_2(uint, mul24, x *y)
OF_3(int, mad24, x *y + z)
OF_3(uint, mad24, x *y + z)

// ---- Conversions --------------------------------------------------------------------------------

#define EACH_CONVERTED(n, to, from) EACH(to##n, n, convert_##to##n, (from##n x), convert_##to(x[i]))
#define CONVERTED(to, from)                                                                        \
    SINGLE(to, convert_##to, (from x), (to)x)                                                      \
    FOR_WIDTHS(EACH_CONVERTED, to, from)
#define CONVERTED_TO(to)                                                                           \
    CONVERTED(to, char)                                                                            \
    CONVERTED(to, uchar)                                                                           \
    CONVERTED(to, short)                                                                           \
    CONVERTED(to, ushort)                                                                          \
    CONVERTED(to, int)                                                                             \
    CONVERTED(to, uint)                                                                            \
    CONVERTED(to, long)                                                                            \
    CONVERTED(to, ulong)                                                                           \
    CONVERTED(to, float)                                                                           \
    CONVERTED(to, double)
CONVERTED_TO(char)
CONVERTED_TO(uchar)
CONVERTED_TO(short)
CONVERTED_TO(ushort)
CONVERTED_TO(int)
CONVERTED_TO(uint)
CONVERTED_TO(long)
CONVERTED_TO(ulong)
CONVERTED_TO(float)
CONVERTED_TO(double)

// Rounded to zero, to the nearest, down, up; and within what the type can hold.
#define EACH_ROUNDED(n, to, how)                                                                   \
    EACH(to##n, n, convert_##to##n##how, (float##n x), convert_##to##how(x[i]))
#define ROUNDED(to, how, result)                                                                   \
    SINGLE(to, convert_##to##how, (float x), result)                                               \
    FOR_WIDTHS(EACH_ROUNDED, to, how)
#define ROUNDED_TO(to, least, most)                                                                \
    ROUNDED(to, _rtz, (to)x)                                                                       \
    ROUNDED(to, _rte, (to)rint(x))                                                                 \
    ROUNDED(to, _rtn, (to)floor(x))                                                                \
    ROUNDED(to, _rtp, (to)ceil(x))                                                                 \
    ROUNDED(to, _sat, x != x ? 0 : x <= (float)least ? least : x >= (float)most ? most : (to)x)
ROUNDED_TO(uchar, 0, UCHAR_MAX)
ROUNDED_TO(int, INT_MIN, INT_MAX)
ROUNDED_TO(uint, 0, UINT_MAX)

// ---- Points and directions ----------------------------------------------------------------------

#define OF_POINTS(n, type)                                                                         \
    type OVERLOADABLE dot(type##n x, type##n y)                                                    \
    {                                                                                              \
        type sum = x[0] * y[0];                                                                    \
        for (int i = 1; i < n; i++) {                                                              \
            sum += x[i] * y[i];                                                                    \
        }                                                                                          \
        return sum;                                                                                \
    }                                                                                              \
    SINGLE(type, length, (type##n x), sqrt(dot(x, x)))                                             \
    SINGLE(type, distance, (type##n x, type##n y), length(x - y))                                  \
    SINGLE(type##n, normalize, (type##n x), x / length(x))
#define FAST_OF_POINTS(type)                                                                       \
    SINGLE(float, fast_length, (type x), length(x))                                                \
    SINGLE(float, fast_distance, (type x, type y), distance(x, y))                                 \
    SINGLE(type, fast_normalize, (type x), normalize(x))
#define OF_POINTS_ON_A_LINE(type)                                                                  \
    SINGLE(type, dot, (type x, type y), x *y)                                                      \
    SINGLE(type, length, (type x), fabs(x))                                                        \
    SINGLE(type, distance, (type x, type y), fabs(x - y))                                          \
    SINGLE(type, normalize, (type x), sign(x))
#define OF_ALL_POINTS(type)                                                                        \
    OF_POINTS_ON_A_LINE(type)                                                                      \
    OF_POINTS(2, type)                                                                             \
    OF_POINTS(3, type)                                                                             \
    OF_POINTS(4, type)                                                                             \
    SINGLE(type##3, cross, (type##3 x, type##3 y), x.yzx *y.zxy - x.zxy * y.yzx)                   \
    SINGLE(type##4, cross, (type##4 x, type##4 y), (type##4)(cross(x.xyz, y.xyz), 0))
OF_ALL_POINTS(float)
OF_ALL_POINTS(double)
FAST_OF_POINTS(float)
FAST_OF_POINTS(float2)
FAST_OF_POINTS(float3)
FAST_OF_POINTS(float4)

// ---- Memory -------------------------------------------------------------------------------------

// Work-items run one after the other.
#define CHANGED(function, type, result)                                                            \
    type OVERLOADABLE function(volatile global type *number, type value)                           \
    {                                                                                              \
        const type before = *number;                                                               \
        *number = result;                                                                          \
        return before;                                                                             \
    }
#define ATOMICS(type)                                                                              \
    CHANGED(atomic_xchg, type, value)                                                              \
    CHANGED(atomic_add, type, before + value)                                                      \
    CHANGED(atomic_sub, type, before - value)                                                      \
    CHANGED(atomic_min, type, min(before, value))                                                  \
    CHANGED(atomic_max, type, max(before, value))                                                  \
    CHANGED(atomic_and, type, before &value)                                                       \
    CHANGED(atomic_or, type, before | value)                                                       \
    CHANGED(atomic_xor, type, before ^ value)                                                      \
    SINGLE(type, atomic_inc, (volatile global type * number), (*number)++)                         \
    SINGLE(type, atomic_dec, (volatile global type * number), (*number)--)
ATOMICS(int)
ATOMICS(uint)

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
LOADS_AND_STORES(double)
LOADS_AND_STORES(uchar)
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
