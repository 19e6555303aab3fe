// What is known of wrong lists of ids, and of wrong counts of them (labs 02 and 06).
#ifndef JUDGE_PACKED_LIST_H
#define JUDGE_PACKED_LIST_H

#include "diagnosis.h"
#include "layout.h"

// Is a number what 8 or 16 bits hold of the right one?
Cause number_cause(u32 found, u32 expected);

// The same of all ids of a list; or do they stand the other way round?
Cause list_cause(const u32 *found, const u32 *expected, u32 n);

#endif
