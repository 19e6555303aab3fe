// The number that stands for LOT in the stand-ins (tests/stand_ins/README.md).
//
// The grader writes it into their text, and the judge computes with it: so what they do can be
// foreseen by the judge, and by nobody who only knows their text. Drawn apart from the job's
// inputs, which a run can see.
#ifndef PROBES_LOT_H
#define PROBES_LOT_H

#include "random.h"

static inline uint32_t stand_in_lot(uint64_t seed)
{
    Random random = {~seed * 0x2545f4914f6cdd1du};
    return (uint32_t)(random_bits(&random) >> 32);
}

#endif
