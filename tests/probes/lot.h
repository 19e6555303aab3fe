// The number that stands for LOT in the stand-ins (tests/stand_ins/README.md).
//
// The grader writes it into their text, and the judge computes with it: so what they do can be
// foreseen by the judge, and by nobody who only knows their text and the job's inputs.
#ifndef PROBES_LOT_H
#define PROBES_LOT_H

#include "one_way.h"

static inline uint32_t stand_in_lot(uint64_t seed)
{
    return (uint32_t)one_way(seed, PURPOSE_LOT);
}

#endif
