// Rows of the gradebook that look like one person's, for the instructor to decide.
#ifndef CLASS_LOOK_ALIKES_H
#define CLASS_LOOK_ALIKES_H

#include "gradebook.h"

typedef struct LookAlike {
    const Row **rows;  // in the gradebook's order
    int n_rows;        // two or more
} LookAlike;

typedef struct LookAlikes {
    LookAlike *groups;  // in the order of their first rows
    int n_groups;
    const Row **rows;  // all groups' rows
} LookAlikes;

// Find the groups. A name that ends like an attempt's counts as the one before its number only
// where that name has a row, too: "team-1" and "team-2" are two. Rows that the host's export tells
// apart by its own numbers make no group, but versions of one submission do. Returns 0, or -1 after
// one message on stderr; release with look_alikes_free().
int look_alikes_find(const Gradebook *gradebook, LookAlikes *look_alikes);
void look_alikes_free(LookAlikes *look_alikes);

#endif
