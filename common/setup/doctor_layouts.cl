// What the device says of the structures that it shares with the host: of each its size, and where
// its last field is.
//
// Read next: doctor_device.c, which compares.
#include "doctor_structures.h"

// d_layouts[2 * structures]: bytes.
kernel void layouts(global uint *d_layouts)
{
    uint n = 0;
#define LAYOUT(type, last)                                                                         \
    {                                                                                              \
        type value;                                                                                \
        d_layouts[n++] = sizeof value;                                                             \
        d_layouts[n++] = (uint)((uchar *)&value.last - (uchar *)&value);                           \
    }
#include "doctor_layouts.h"
}
