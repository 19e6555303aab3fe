// Leaves to be packed, and how lists of their ids may be wrong (labs 02 and 06).
#ifndef JUDGE_PACKED_LIST_H
#define JUDGE_PACKED_LIST_H

#include "jobs.h"
#include "random.h"

// A leaf of n_least ids or more; or edge number `edge`, from 0 on, which is nearly the same in
// every job.
enum { N_PACK_EDGES = 6 };
PackJob pack_roll(Random *random, int edge, u32 n_least);

// How a list of ids may be wrong: from the last to the first; positions for ids; as many bytes
// copied as there are ids; of each id these bits.
int is_reversed(const u32 *found, const u32 *expected, u32 n);
int are_positions(const u32 *found, u32 n);
int is_copied_in_bytes(const u32 *found, const u32 *expected, u32 n);
int is_cut(const u32 *found, const u32 *expected, u32 n, u32 bits);

#endif
