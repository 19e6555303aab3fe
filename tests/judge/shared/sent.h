// Inputs that a whole run sends to a function: in pictures, or while it builds trees.
//
// A function that is wrong for them only would fail checks of other tasks, and pass its own. So its
// own checks get some of them, among those that are rolled.
#ifndef JUDGE_SENT_H
#define JUDGE_SENT_H

#include "random.h"

#include <stddef.h>
#include <string.h>

// A place for inputs of one kind among a function's. What they do not fill stays as it is.
typedef struct Sent {
    void *jobs;      // where the first goes
    size_t n_bytes;  // of each
    int n;           // how many there is room for
    int n_come;      // how many there were
} Sent;
#define SENT_TO(first, room) ((Sent){.jobs = (first), .n_bytes = sizeof *(first), .n = (room)})

// Keep an input: of more than there is room for, each has the same chance.
static inline void sent_keep(Sent *sent, Random *random, const void *job)
{
    const int place = (int)random_integer(random, 0, sent->n_come);
    const int i = sent->n_come < sent->n ? sent->n_come : place;
    sent->n_come++;
    if (i < sent->n) {
        memcpy((char *)sent->jobs + (size_t)i * sent->n_bytes, job, sent->n_bytes);
    }
}

#endif
