// Number types and the layout check for structures that host and device share.
//
// Every header in kernels/ is read twice: by the C compiler for the host and by the OpenCL
// compiler for the device. Both must see the same bytes. So a shared structure holds only the
// types below (no float3, bool, size_t, pointers or bit-fields: their sizes differ between the
// two sides), and a LAYOUT_ASSERT after it stops the build on the side that disagrees.
// Flow: scene -> BUFFERS -> KERNEL -> image. Read next: circle.h.
#ifndef KERNELS_LAYOUT_H
#define KERNELS_LAYOUT_H

// Bare clang defines __OPENCL_C_VERSION__ but not __OPENCL_VERSION__; OpenCL drivers define both.
#ifdef __OPENCL_C_VERSION__
typedef float f32;
typedef int i32;
typedef uint u32;
typedef uchar u8;
typedef ulong u64;
#define LAYOUT_ASSERT(type, n_bytes)                                                               \
    typedef char layout_assert_##type[sizeof(type) == (n_bytes) ? 1 : -1]
#else
#include <stdint.h>
typedef float f32;
typedef int32_t i32;
typedef uint32_t u32;
typedef uint8_t u8;
typedef uint64_t u64;
#define LAYOUT_ASSERT(type, n_bytes)                                                               \
    _Static_assert(sizeof(type) == (n_bytes), "host and device must agree on the size of " #type)
#endif

#endif
