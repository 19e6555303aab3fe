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

// From fewer ids than these nothing of the following two is concluded.
#define ENOUGH 4

static int are_positions(const u32 *found, u32 n)
{
    u32 i = 0;
    while (i < n && found[i] == i) {
        i++;
    }
    return n >= ENOUGH && i == n;
}

// Are as many bytes right as there are ids, and no whole id behind them?
static int is_copied_in_bytes(const u32 *found, const u32 *expected, u32 n)
{
    const u32 n_whole = n / (u32)sizeof(u32);
    u32 i = 0;
    while (i < n && (found[i] == expected[i]) == (i < n_whole)) {
        i++;
    }
    return n >= ENOUGH && i == n;
}

Cause list_cause(const u32 *found, const u32 *expected, u32 n)
{
    return (Cause){.says = is_reversed(found, expected, n)
                               ? "the ids stand there from the last to the first, and must ascend"
                           : are_positions(found, n)
                               ? "those are positions in the list that was given, not its ids"
                           : is_copied_in_bytes(found, expected, n)
                               ? "as many bytes were copied as there are ids"
                           : is_cut(found, expected, n, 0xff)   ? "of each id 8 bits are there"
                           : is_cut(found, expected, n, 0xffff) ? "of each id 16 bits are there"
                                                                : NULL};
}
