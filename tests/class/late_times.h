// When each row was handed in, by whose word: the instructor's, else the system's. Where only a
// student can have written it, or nobody has, it stays unknown.
//
// Read next: late_times.c, evidence.h. Used by lateness.c alone.
#ifndef CLASS_LATE_TIMES_H
#define CLASS_LATE_TIMES_H

#include "lateness.h"

// Fill in what lateness->rows, whose deadlines are known, can know of the time.
//   worksheet   the list of participants, or NULL
// Returns 0, or -1 after one message, where what the instructor wrote is no time, or when memory
// runs out.
int late_times_find(Lateness *lateness, const Gradebook *gradebook, const Worksheet *worksheet);

#endif
