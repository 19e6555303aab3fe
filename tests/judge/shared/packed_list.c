// Lists of leaves, and how they may be wrong (see packed_list.h).
#include "packed_list.h"

PackJob pack_roll(Random *random, int edge, u32 n_least)
{
    // Empty leaves and the first one of a tree; then long lists, before the leaf and in it. Their
    // ids are too large for 16 bits.
    static const struct {
        u32 n_before, n_ids;
    } edges[N_PACK_EDGES] = {{5, 0}, {9, 0}, {0, 2}, {0, 0}, {PACK_MAX_IDS, 3}, {7, PACK_MAX_IDS}};
    enum { MOST_IDS = 24 };
    PackJob job = {.id = (u32)random_integer(random, 1, PACK_NODES - 1)};
    job.n_before = (u32)random_integer(random, 1, 20);
    job.n_ids = (u32)random_integer(random, n_least, MOST_IDS);
    u32 id = (u32)random_integer(random, 0, 5);
    if (edge >= 0) {
        job.n_before = edges[edge].n_before;
        job.n_ids = edges[edge].n_ids;
        id += 90000;
    }
    for (u32 j = 0; j < job.n_ids; j++) {
        job.ids[j] = id;
        id += (u32)random_integer(random, 1, 90);
    }
    return job;
}

int is_cut(const u32 *found, const u32 *expected, u32 n, u32 bits)
{
    u32 i = 0;
    while (i < n && found[i] == (expected[i] & bits)) {
        i++;
    }
    return i == n;
}

int is_reversed(const u32 *found, const u32 *expected, u32 n)
{
    u32 i = 0;
    while (i < n && found[i] == expected[n - 1 - i]) {
        i++;
    }
    return i == n;
}

int are_positions(const u32 *found, u32 n)
{
    u32 i = 0;
    while (i < n && found[i] == i) {
        i++;
    }
    return i == n;
}

int is_copied_in_bytes(const u32 *found, const u32 *expected, u32 n)
{
    const u32 n_whole = n / (u32)sizeof(u32);
    u32 i = 0;
    while (i < n && (found[i] == expected[i]) == (i < n_whole)) {
        i++;
    }
    return i == n;
}
