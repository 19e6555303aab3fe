// greedy_judge: what a judge would be over answers that were made to exhaust it.
//
//     greedy_judge <requests >replies
//
// Used by unit/test_judge_process.c in the place of a judge, whose requests it takes
// (judge/judge_tool.c) and by whose functions it is limited, to a second of processor time a
// request and 256 MB. Verdict 0 computes for four seconds, verdict 1 fills 512 MB, verdict 2 takes
// half a second. Whoever is not stopped over that replies "passed".
#include "judge_limits.h"
#include "sections.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static void compute(double seconds)
{
    const clock_t end = clock() + (clock_t)(seconds * CLOCKS_PER_SEC);
    while (clock() < end) {
    }
}

static void fill(size_t n_bytes)
{
    const size_t step = (size_t)16 << 20;
    for (size_t n = 0; n < n_bytes; n += step) {
        char *bytes = malloc(step);
        if (bytes == NULL) {
            exit(2);  // as the judge does
        }
        memset(bytes, 1, step);  // never freed: that is the point
    }
}

int main(void)
{
    char word[16], argument[64];
    size_t n_bytes;
    limit_memory((size_t)256 << 20);
    scanf("%*s");  // the seed
    while (scanf("%15s %63s %zu", word, argument, &n_bytes) == 3) {
        limit_time(1);
        for (size_t i = 0; i <= n_bytes; i++) {
            getchar();  // the end of the line, and answers
        }
        if (strcmp(word, "verdict") != 0) {
            printf("0\n");
            fflush(stdout);
            continue;
        }
        switch (argument[0]) {
        case '0':
            compute(4);
            break;
        case '1':
            fill((size_t)512 << 20);
            break;
        default:
            compute(0.5);
        }
        printf("%d\n", (int)(SECTION_NAME_BYTES + sizeof(uint64_t)));
        section_write(stdout, "passed", "", 0);
        fflush(stdout);
    }
    return EXIT_SUCCESS;
}
