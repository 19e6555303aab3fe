// Leaves to be packed, and what is known of wrong lists of ids and of wrong counts of them (labs 02
// and 06).
#ifndef JUDGE_PACKED_LIST_H
#define JUDGE_PACKED_LIST_H

#include "diagnosis.h"
#include "jobs.h"
#include "random.h"

// A leaf of n_least ids or more; or edge number `edge`, from 0 on, which is nearly the same in
// every job.
enum { N_PACK_EDGES = 6 };
PackJob pack_roll(Random *random, int edge, u32 n_least);

// Is a number what 8 or 16 bits hold of the right one?
Cause number_cause(u32 found, u32 expected);

// The same of all ids of a list; or do they stand the other way round?
Cause list_cause(const u32 *found, const u32 *expected, u32 n);

#endif
