// Causes of wrong lists (see packed_list.h).
#include "packed_list.h"

#include <stddef.h>

Cause number_cause(u32 found, u32 expected)
{
    return (Cause){.says = found == expected              ? NULL
                           : found == (expected & 0xff)   ? "that is what 8 bits hold of it"
                           : found == (expected & 0xffff) ? "that is what 16 bits hold of it"
                                                          : NULL};
}

// Is each entry what these bits hold of the right one?
static int is_cut(const u32 *found, const u32 *expected, u32 n, u32 bits)
{
    u32 i = 0;
    while (i < n && found[i] == (expected[i] & bits)) {
        i++;
    }
    return i == n;
}

static int is_reversed(const u32 *found, const u32 *expected, u32 n)
{
    u32 i = 0;
    while (i < n && found[i] == expected[n - 1 - i]) {
        i++;
    }
    return i == n;
}

Cause list_cause(const u32 *found, const u32 *expected, u32 n)
{
    return (Cause){.says = is_reversed(found, expected, n)
                               ? "the ids stand there from the last to the first, and must ascend"
                           : is_cut(found, expected, n, 0xff)   ? "of each id 8 bits are there"
                           : is_cut(found, expected, n, 0xffff) ? "of each id 16 bits are there"
                                                                : NULL};
}
