// Ranking the rows that have a figure (see leaderboard.h).
#include "leaderboard.h"

#include <stdlib.h>

static int places_compare(const void *left, const void *right)
{
    const Row *a = ((const Place *)left)->row;
    const Row *b = ((const Place *)right)->row;
    return a->leaderboard != b->leaderboard ? (a->leaderboard < b->leaderboard ? 1 : -1)
                                            : (a > b) - (a < b);
}

int leaderboard_find(const Gradebook *gradebook, Leaderboard *leaderboard)
{
    Place *places = calloc((size_t)gradebook->n_rows + 1, sizeof *places);
    int n = 0;
    *leaderboard = (Leaderboard){.places = places};
    if (places == NULL) {
        fprintf(stderr, "gradebook: out of memory\n");
        return -1;
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (gradebook->rows[i].leaderboard != 0) {
            places[n++].row = &gradebook->rows[i];
        }
    }
    qsort(places, (size_t)n, sizeof *places, places_compare);
    for (int i = 0; i < n; i++) {
        const int is_equal = i > 0 && places[i].row->leaderboard == places[i - 1].row->leaderboard;
        places[i].rank = is_equal ? places[i - 1].rank : i + 1;
    }
    leaderboard->n_places = n;
    return 0;
}

void leaderboard_free(Leaderboard *leaderboard)
{
    free(leaderboard->places);
    *leaderboard = (Leaderboard){0};
}
