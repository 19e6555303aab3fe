// Lab 10's next_tile_waiting: its inputs, and what must come out. All numbers are quarters, or
// the least beside one, so that nothing is rounded.
#include "judge_10.h"

#include "job_stack.h"
#include "message.h"
#include "random3d.h"
#include "words.h"

#include <math.h>

// ---- Inputs -----------------------------------------------------------------------------------

// Parts that overlap, in no order; the farthest hit among them, exactly at the begin of one, or
// nowhere. Now and then many more wait on top that begin behind it, up to a stack that is full.
static TileWaitingJob roll_waiting(Random *random)
{
    TileWaitingJob job = {.at = {(u32)random_integer(random, 3, 1000), 1, 2}};
    // The leaf's part may reach far beyond what waits.
    job.at.t_max = one_in(random, 2) ? 2 : 100;
    const int is_empty = random_integer(random, 0, 5) == 0;
    const u32 n = is_empty ? 0 : (u32)random_integer(random, 1, STACK_ENTRIES);
    job.todo = random_stack(random, 0, n);
    for (u32 i = 0; i < n; i++) {  // a part may be a point
        TodoEntry *waits = &job.todo.upper[i];
        waits->t_max = one_in(random, 4) ? waits->t_min : waits->t_max;
    }
    job.farthest = random_quarters(random, 30, 90);
    const int kind = (int)random_integer(random, 0, 6);
    if (n > 0 && kind == 0) {
        job.farthest = job.todo.upper[random_integer(random, 0, (int)n - 1)].t_min;
    } else if (kind == 1) {
        job.farthest = INFINITY;
    } else if (kind == 2) {
        // Before all that waits, and now and then before the leaf, too.
        job.farthest = random_quarters(random, 1, one_in(random, 2) ? 3 : 30);
    } else if (n > 0 && kind == 3) {  // the least before where one begins
        const TodoEntry waits = job.todo.upper[random_integer(random, 0, (int)n - 1)];
        job.farthest = nextafterf(waits.t_min, 0);
    } else if (n > 0 && kind == 4) {  // the least behind that
        const TodoEntry waits = job.todo.upper[random_integer(random, 0, (int)n - 1)];
        job.farthest = nextafterf(waits.t_min, INFINITY);
    }
    if (isfinite(job.farthest) && one_in(random, 4)) {
        const u32 room = TODO_SIZE - n;
        job.n_behind = one_in(random, 2) ? room : (u32)random_integer(random, 1, room);
    }
    return job;
}

void roll_waiting_10(Random *random, Job10 *job)
{
    for (int i = 0; i < COUNT(job->waiting); i++) {
        job->waiting[i] = roll_waiting(random);
    }
}

// ---- Judging ----------------------------------------------------------------------------------

enum {
    WAITING_TOP_ENDS = 1,
    WAITING_TAKES_TOP,
    WAITING_ANY_HIT,
    WAITING_INVERTED,
    WAITING_NOT_AT_SAME,
    WAITING_BY_T_MAX,
    WAITING_SWAPPED,
    WAITING_PART_KEPT,
    WAITING_T_MAX_KEPT,
    WAITING_T_MIN_KEPT,
    WAITING_OLDEST,
    WAITING_STAYS,
    WAITING_ONE_LEFT,
    WAITING_TWO_ONLY,
    WAITING_LEAF_ENDS,
    WAITING_EPSILON,
    WAITING_NO_HIT_ENDS,
    WAITING_TOO_EARLY,
    WAITING_BY_LEAF,
    WAITING_ENDS_AT_HIT,
    WAITING_TWO_TRIED,
    WAITING_THREE_TRIED,
    WAITING_FOUR_TRIED,
    WAITING_EIGHT_TRIED,
    WAITING_TEN_TRIED,
    WAITING_SIXTEEN_TRIED,
    WAITING_POINT_LEFT,
    WAITING_AT_KEPT,
    WAITING_NONE_GOES_ON,
    WAITING_TOP_ENDS_AT_SAME,
    WAITING_OF_LAB_07,
    WAITING_OF_LAB_07_AT_SAME,
    WAITING_LEAF_ENDS_AT_SAME,
};
#define TOP_ENDS                                                                                   \
    "the node on top begins behind every hit, but the one below it need not: parts of many rays "  \
    "overlap"
#define LAB_07                                                                                     \
    "that is lab 07's rule: a farthest hit inside of the leaf is no end here, as parts of many "   \
    "rays overlap"

#define FEW_LEFT_OUT                                                                               \
    "the search ended after some nodes that are left out: however many they are, it goes on"
static const Cause waiting_mistakes[] = {
    [WAITING_TOP_ENDS] = {.says = TOP_ENDS},
    [WAITING_TOP_ENDS_AT_SAME] = {.says = TOP_ENDS},
    [WAITING_TAKES_TOP] =
        {.says = "the search goes on into nodes that begin behind the farthest hit: they are left "
                 "out, each of them"},
    [WAITING_ANY_HIT] = {.says = "that is as if the search ended as soon as every ray has a hit: "
                                 "what begins before the farthest may hold a nearer one"},
    [WAITING_INVERTED] = {.says = "the comparison with the farthest hit is inverted"},
    [WAITING_NOT_AT_SAME] = {.says = "a node that begins exactly at the farthest hit must not be "
                                     "left out: a sphere with a lower index may be just as far "
                                     "away"},
    [WAITING_BY_T_MAX] = {.says = "a node can matter where it begins before the farthest hit, "
                                  "wherever it ends: its t_min counts"},
    [WAITING_SWAPPED] = {.says = "1 and 0 are swapped: 0 is the end"},
    [WAITING_PART_KEPT] =
        {.says = "that is as if t_min and t_max were not taken from the stack with the node"},
    [WAITING_T_MAX_KEPT] = {.says =
                                "that is as if t_max were not taken from the stack with the node"},
    [WAITING_T_MIN_KEPT] = {.says =
                                "that is as if t_min were not taken from the stack with the node"},
    [WAITING_OLDEST] = {.says =
                            "that is as if the node that waits longest came from the stack first"},
    [WAITING_STAYS] = {.says = "the node is not taken off the stack: it waits still"},
    [WAITING_ONE_LEFT] = {.says = "the search ended while one node was still waiting"},
    [WAITING_LEAF_ENDS] = {.says = LAB_07},
    [WAITING_LEAF_ENDS_AT_SAME] = {.says = LAB_07},
    [WAITING_OF_LAB_07] = {.says = LAB_07},
    [WAITING_OF_LAB_07_AT_SAME] = {.says = LAB_07},
    [WAITING_EPSILON] = {.says = "a node that begins behind the farthest hit is left out, however "
                                 "little behind: without an epsilon"},
    [WAITING_NO_HIT_ENDS] = {.says = "that is as if the search ended while a ray has no hit yet: "
                                     "INFINITY is farther than all that waits"},
    [WAITING_TOO_EARLY] = {.says = "a node that begins before the farthest hit is visited, however "
                                   "little before: without an epsilon"},
    [WAITING_BY_LEAF] = {.says = "where the waiting node begins counts, not where the leaf did"},
    [WAITING_ENDS_AT_HIT] = {.says = "the part of the node ends at the farthest hit, also where it "
                                     "ended before: a part never grows"},
    [WAITING_TWO_TRIED] = {.says = FEW_LEFT_OUT},
    [WAITING_THREE_TRIED] = {.says = FEW_LEFT_OUT},
    [WAITING_FOUR_TRIED] = {.says = FEW_LEFT_OUT},
    [WAITING_EIGHT_TRIED] = {.says = FEW_LEFT_OUT},
    [WAITING_TEN_TRIED] = {.says = FEW_LEFT_OUT},
    [WAITING_SIXTEEN_TRIED] = {.says = FEW_LEFT_OUT},
    [WAITING_POINT_LEFT] = {.says = "a node whose part is a point, t_min and t_max equal, is "
                                    "visited, too: a hit may be exactly there"},
    [WAITING_AT_KEPT] = {.says = "*at is still the leaf: the node from the stack is not handed on"},
    [WAITING_NONE_GOES_ON] = {.says = "where nothing waits the search is over, whether each ray "
                                      "has a hit or not"},
    [WAITING_TWO_ONLY] = {.says = "more than one node in a row may be left out"},
};

// More than the least before a begin, less than a quarter.
#define LEAST_STEP 0x1p-10f

static int matters(const TileWaitingJob *job, TodoEntry entry, int mistake)
{
    const float from = mistake == WAITING_BY_T_MAX  ? entry.t_max
                       : mistake == WAITING_BY_LEAF ? job->at.t_min
                                                    : entry.t_min;
    if (mistake == WAITING_POINT_LEFT && entry.t_min == entry.t_max) {
        return 0;
    }
    const int takes_top = mistake == WAITING_TAKES_TOP || mistake == WAITING_OF_LAB_07 ||
                          mistake == WAITING_OF_LAB_07_AT_SAME;
    const int not_at_same = mistake == WAITING_NOT_AT_SAME || mistake == WAITING_TOP_ENDS_AT_SAME;
    return takes_top                      ? 1
           : mistake == WAITING_INVERTED  ? from > job->farthest
           : not_at_same                  ? from < job->farthest
           : mistake == WAITING_ANY_HIT   ? isinf(job->farthest)
           : mistake == WAITING_EPSILON   ? from <= job->farthest + LEAST_STEP
           : mistake == WAITING_TOO_EARLY ? from <= job->farthest - LEAST_STEP
                                          : from <= job->farthest;
}

// Entry i of the stack, from the bottom.
static TodoEntry entry_at(const TileWaitingJob *job, u32 i)
{
    return i < job->todo.n ? job->todo.upper[i] : (TodoEntry){WAITS_NODE, WAITS_FROM, WAITS_TO};
}

// After how many nodes a mistake ends the search; a stack never holds more than TODO_SIZE.
static u32 most_tried(int mistake)
{
    return mistake == WAITING_TOP_ENDS || mistake == WAITING_TOP_ENDS_AT_SAME ? 1
           : mistake == WAITING_TWO_TRIED                                     ? 2
           : mistake == WAITING_THREE_TRIED                                   ? 3
           : mistake == WAITING_FOUR_TRIED                                    ? 4
           : mistake == WAITING_EIGHT_TRIED                                   ? 8
           : mistake == WAITING_TEN_TRIED                                     ? 10
           : mistake == WAITING_SIXTEEN_TRIED                                 ? 16
                                                                              : TODO_SIZE;
}

static NextWaitingAnswer expected_waiting(const TileWaitingJob *job, int mistake)
{
    NextWaitingAnswer answer = {.at = job->at, .todo = job->todo};
    StackState *todo = &answer.todo;
    todo->n += job->n_behind;
    for (u32 i = job->todo.n; i < STACK_ENTRIES; i++) {
        todo->upper[i] = entry_at(job, i);
    }
    const int is_oldest = mistake == WAITING_OLDEST;
    const u32 left = mistake == WAITING_ONE_LEFT ? 1 : 0;
    TodoEntry next = job->at;
    const int leaf_ends = mistake == WAITING_LEAF_ENDS || mistake == WAITING_OF_LAB_07;
    const int ends_at_same =
        mistake == WAITING_LEAF_ENDS_AT_SAME || mistake == WAITING_OF_LAB_07_AT_SAME;
    if ((leaf_ends && job->farthest < job->at.t_max) ||
        (ends_at_same && job->farthest <= job->at.t_max) ||
        (mistake == WAITING_NO_HIT_ENDS && isinf(job->farthest))) {
        return answer;
    }
    for (u32 n_taken = 0; todo->n > left && n_taken < most_tried(mistake) && !answer.goes_on;
         n_taken++) {
        next = entry_at(job, is_oldest ? n_taken : todo->n - 1);
        todo->n--;
        answer.goes_on =
            matters(job, next, mistake) || (mistake == WAITING_TWO_ONLY && n_taken == 1);
    }
    if (answer.goes_on) {
        const int keeps_part = mistake == WAITING_PART_KEPT;
        answer.at.node = next.node;
        answer.at.t_min = keeps_part || mistake == WAITING_T_MIN_KEPT ? job->at.t_min : next.t_min;
        answer.at.t_max = keeps_part || mistake == WAITING_T_MAX_KEPT ? job->at.t_max
                          : mistake == WAITING_ENDS_AT_HIT            ? job->farthest
                                                                      : next.t_max;
        todo->n += mistake == WAITING_STAYS;
    }
    if (mistake == WAITING_AT_KEPT) {
        answer.at = job->at;
    }
    answer.goes_on |= mistake == WAITING_NONE_GOES_ON && isinf(job->farthest);
    answer.goes_on ^= mistake == WAITING_SWAPPED;
    return answer;
}

static int end_agrees(const void *job, int i, const void *answers, int mistake)
{
    const NextWaitingAnswer expected = expected_waiting(&((const Job10 *)job)->waiting[i], mistake);
    return (((const NextWaitingAnswer *)answers)[i].goes_on != 0) == expected.goes_on;
}

// Is a node handed on with its part? What of this lies behind the farthest hit cannot matter any
// more, so a right answer may cut it off.
static int is_handed_on(const TileWaitingJob *job, TodoEntry found, TodoEntry expected)
{
    return found.node == expected.node && found.t_min == expected.t_min &&
           found.t_max >= fminf(expected.t_max, job->farthest) && found.t_max <= expected.t_max;
}

// Where the search is over, at and the stack do not matter.
static int next_agrees(const void *job, int i, const void *answers, int mistake)
{
    const TileWaitingJob *input = &((const Job10 *)job)->waiting[i];
    const NextWaitingAnswer *found = &((const NextWaitingAnswer *)answers)[i];
    const NextWaitingAnswer expected = expected_waiting(input, mistake);
    if (mistake != 0 && !expected.goes_on) {
        return !found->goes_on;
    }
    // What lies below is untouched in the order in which it came; of the oldest only how many.
    return !expected.goes_on ||
           (found->goes_on &&
            (mistake == 0 ? is_handed_on(input, found->at, expected.at)
                          : same_entry(found->at, expected.at)) &&
            (mistake == WAITING_OLDEST || same_stack(&found->todo, &expected.todo)));
}

// "from the top [12, 14] [11, 12.5]", with "30 times [1048576, 2097152]" before them.
static Words stack_words(const TileWaitingJob *job)
{
    Words all = words("%s", job->todo.n + job->n_behind == 0 ? "nothing" : "from the top");
    if (job->n_behind > 0) {
        all = words("%s %u times [%.9g, %.9g]", all.text, job->n_behind, (double)WAITS_FROM,
                    (double)WAITS_TO);
    }
    for (u32 i = job->todo.n; i > 0; i--) {
        const TodoEntry entry = job->todo.upper[i - 1];
        all = words("%s [%g, %g]", all.text, entry.t_min, entry.t_max);
    }
    return all;
}

static char *describe_waiting(const void *pointer, int i, const void *answers)
{
    const TileWaitingJob *job = &((const Job10 *)pointer)->waiting[i];
    const NextWaitingAnswer expected = expected_waiting(job, 0);
    return message_new("the farthest hit is at %.9g; %s waiting: found %s, expected %s",
                       job->farthest, stack_words(job).text,
                       next_waiting_words((const NextWaitingAnswer *)answers + i).text,
                       next_waiting_words(&expected).text);
}

const Function tile_end_10 = {"tile_waiting", N_TILE_WAITING_INPUTS, sizeof(NextWaitingAnswer),
                              COMPARED(end_agrees, describe_waiting, waiting_mistakes)};
const Function tile_next_10 = {"tile_waiting", N_TILE_WAITING_INPUTS, sizeof(NextWaitingAnswer),
                               COMPARED(next_agrees, describe_waiting, waiting_mistakes)};
