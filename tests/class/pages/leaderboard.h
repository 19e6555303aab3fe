// Who comes first by the figure of a lab's race, of those who have one. It gives and costs no
// points, and a submission can forge it (tests/grader/run/race.h).
#ifndef CLASS_LEADERBOARD_H
#define CLASS_LEADERBOARD_H

#include "gradebook.h"

typedef struct Place {
    const Row *row;
    int rank;  // from 1 on; who is equal shares one, and the next ones are left out: 1, 1, 3
} Place;

typedef struct Leaderboard {
    Place *places;  // the largest figure first; of equal ones in the gradebook's order
    int n_places;   // 0 in a lab without a leaderboard
} Leaderboard;

// Returns 0, or -1 after one message on stderr. Release with leaderboard_free().
int leaderboard_find(const Gradebook *gradebook, Leaderboard *leaderboard);
void leaderboard_free(Leaderboard *leaderboard);

#endif
