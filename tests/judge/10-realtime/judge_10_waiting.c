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
    TileWaitingJob job = {.at = {(u32)random_integer(random, 3, 100000), 1, 2}};
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
    // Scenes are of any size: a power of two rounds nothing.
    const float factor = one_in(random, 2) ? 1 : ldexpf(1, (int)random_integer(random, -6, 8));
    job.farthest *= factor;
    job.at.t_min *= factor, job.at.t_max *= factor;
    stack_scale(&job.todo, factor);
    return job;
}

void roll_waiting_10(Random *random, Job10 *job)
{
    for (int i = 0; i < COUNT(job->waiting); i++) {
        job->waiting[i] = roll_waiting(random);
    }
}

// If nothing that waits may hold a nearer hit, all of it is taken from the stack.
const char *suspect_waiting_10(const void *input)
{
    const TileWaitingJob *in = input;
    u32 i = 0;
    while (i < in->todo.n && in->todo.upper[i].t_min > in->farthest) {
        i++;
    }
    return i == in->todo.n ? TAKEN_FROM_EMPTY : NULL;
}

#define GIVEN                                                                                      \
    const TileWaitingJob *in = &((const Job10 *)job)->waiting[i];                                  \
    const NextWaitingAnswer *found = (const NextWaitingAnswer *)answers + i
#define IS_FOUND(expected) same_waiting(found, expected)

// ---- Right ------------------------------------------------------------------------------------

static u32 n_waiting(const TileWaitingJob *in)
{
    return in->todo.n + in->n_behind;
}

// Entry i of the stack, from the bottom.
static TodoEntry entry_at(const TileWaitingJob *in, u32 i)
{
    return i < in->todo.n ? in->todo.upper[i] : (TodoEntry){WAITS_NODE, WAITS_FROM, WAITS_TO};
}

// The search goes on with the node that is n-th from the top.
static NextWaitingAnswer taken(const TileWaitingJob *in, u32 n)
{
    const u32 n_left = n_waiting(in) - n;
    NextWaitingAnswer answer = {.goes_on = 1, .at = entry_at(in, n_left), .todo = in->todo};
    answer.todo.n = n_left;
    for (u32 i = in->todo.n; i < STACK_ENTRIES; i++) {
        answer.todo.upper[i] = entry_at(in, i);
    }
    return answer;
}

static NextWaitingAnswer ended(const TileWaitingJob *in)
{
    return (NextWaitingAnswer){.at = in->at};
}

// The search goes on with the first node from the top that matters, of the first `most`.
typedef int Matters(TodoEntry waits, float limit);
static NextWaitingAnswer search(const TileWaitingJob *in, Matters *matters, float limit, u32 most)
{
    for (u32 n = 1; n <= n_waiting(in) && n <= most; n++) {
        if (matters(entry_at(in, n_waiting(in) - n), limit)) {
            return taken(in, n);
        }
    }
    return ended(in);
}

static int begins_before(TodoEntry waits, float limit)
{
    return waits.t_min <= limit;
}

static NextWaitingAnswer begun_by(const TileWaitingJob *in, float limit)
{
    return search(in, begins_before, limit, TODO_SIZE);
}

static NextWaitingAnswer waiting(const TileWaitingJob *in)
{
    return begun_by(in, in->farthest);
}

RIGHT(is_right_end, (found->goes_on != 0) == waiting(in).goes_on)

// What of a part lies behind the farthest hit cannot matter any more, so a right answer may cut it
// off.
static int is_handed_on(const TileWaitingJob *in, TodoEntry found, TodoEntry expected)
{
    return found.node == expected.node && found.t_min == expected.t_min &&
           found.t_max >= fminf(expected.t_max, in->farthest) && found.t_max <= expected.t_max;
}

static int is_next(const TileWaitingJob *in, const NextWaitingAnswer *found)
{
    const NextWaitingAnswer expected = waiting(in);
    return !expected.goes_on || (found->goes_on && is_handed_on(in, found->at, expected.at) &&
                                 same_stack(&found->todo, &expected.todo));
}

RIGHT(is_right_next, is_next(in, found))

// ---- Mistakes ---------------------------------------------------------------------------------

// By what is compared with what. More than the least before a begin is less than a quarter.
#define LEAST_STEP 0x1p-10f

static int begins_behind(TodoEntry waits, float limit)
{
    return waits.t_min > limit;
}

static int ends_before(TodoEntry waits, float limit)
{
    return waits.t_max <= limit;
}

static int is_longer(TodoEntry waits, float limit)
{
    return waits.t_min <= limit && waits.t_min != waits.t_max;
}

static float all_or_none(int is_all)
{
    return is_all ? INFINITY : -INFINITY;
}

// By how many are left out.
#define TOP_ENDS                                                                                   \
    "the node on top begins behind every hit, but the one below it need not: parts of many rays "  \
    "overlap"

static NextWaitingAnswer tried(const TileWaitingJob *in, u32 most)
{
    return search(in, begins_before, in->farthest, most);
}

static NextWaitingAnswer second_taken(const TileWaitingJob *in)
{
    return n_waiting(in) > 1 && !tried(in, 1).goes_on ? taken(in, 2) : waiting(in);
}

// By where the search ends.
#define LAB_07                                                                                     \
    "that is lab 07's rule: a farthest hit inside of the leaf is no end here, as parts of many "   \
    "rays overlap"

static NextWaitingAnswer with_end(NextWaitingAnswer answer, int goes_on)
{
    answer.goes_on = goes_on;
    return answer;
}

static NextWaitingAnswer ended_if(const TileWaitingJob *in, int is_end, NextWaitingAnswer answer)
{
    return is_end ? ended(in) : answer;
}

static NextWaitingAnswer with_leaf(const TileWaitingJob *in)
{
    NextWaitingAnswer answer = waiting(in);
    answer.at = in->at;
    return answer;
}

static int is_oldest(const TileWaitingJob *in, TodoEntry found)
{
    u32 i = 0;
    while (i < n_waiting(in) && !begins_before(entry_at(in, i), in->farthest)) {
        i++;
    }
    return i < n_waiting(in) && same_entry(found, entry_at(in, i));
}

KNOWN_LIST(known)
{
    GIVEN;

    ANSWERS(takes_top, begun_by(in, INFINITY),
            "the search goes on into nodes that begin behind the farthest hit: they are left out, "
            "each of them");
    ANSWERS(any_hit, begun_by(in, all_or_none(isinf(in->farthest))),
            "that is as if the search ended as soon as every ray has a hit: what begins before the "
            "farthest may hold a nearer one");
    ANSWERS(inverted, search(in, begins_behind, in->farthest, TODO_SIZE),
            "the comparison with the farthest hit is inverted");
    ANSWERS(not_at_same, begun_by(in, nextafterf(in->farthest, 0)),
            "a node that begins exactly at the farthest hit must not be left out: a sphere with a "
            "lower index may be just as far away");
    ANSWERS(by_t_max, search(in, ends_before, in->farthest, TODO_SIZE),
            "a node can matter where it begins before the farthest hit, wherever it ends: its "
            "t_min counts");
    // Of an epsilon whose size is not known: nodes of the search itself may begin that near, or
    // not.
    EACH(epsilon, IS_FOUND(waiting(in)) || IS_FOUND(begun_by(in, in->farthest + LEAST_STEP)),
         "a node that begins behind the farthest hit is left out, however little behind: without "
         "an epsilon");
    ANSWERS(too_early, begun_by(in, in->farthest - LEAST_STEP),
            "a node that begins before the farthest hit is visited, however little before: without "
            "an epsilon");
    ANSWERS(by_leaf, begun_by(in, all_or_none(in->at.t_min <= in->farthest)),
            "where the waiting node begins counts, not where the leaf did");
    ANSWERS(point_left, search(in, is_longer, in->farthest, TODO_SIZE),
            "a node whose part is a point, t_min and t_max equal, is visited, too: a hit may be "
            "exactly there");

    ANSWERS(top_ends, tried(in, 1), TOP_ENDS);
    ANSWERS(top_ends_at_same, search(in, begins_before, nextafterf(in->farthest, 0), 1), TOP_ENDS);
    ANSWERS(two_only, second_taken(in), "more than one node in a row may be left out");
    static const u32 few[] = {2, 3, 4, 8, 10, 16};
    ONE_OF(
        few_left_out, 6, IS_FOUND(tried(in, few[way])),
        "the search ended after some nodes that are left out: however many they are, it goes on");

    // Which node such an answer hands on is not defined.
    EACH(swapped, (found->goes_on != 0) != waiting(in).goes_on,
         "1 and 0 are swapped: 0 is the end");
    ANSWERS(one_left, ended_if(in, waiting(in).todo.n == 0, waiting(in)),
            "the search ended while one node was still waiting");
    ANSWERS(leaf_ends, ended_if(in, in->farthest < in->at.t_max, waiting(in)), LAB_07);
    ANSWERS(leaf_ends_at_same, ended_if(in, in->farthest <= in->at.t_max, waiting(in)), LAB_07);
    ANSWERS(lab_07, ended_if(in, in->farthest < in->at.t_max, begun_by(in, INFINITY)), LAB_07);
    ANSWERS(lab_07_at_same, ended_if(in, in->farthest <= in->at.t_max, begun_by(in, INFINITY)),
            LAB_07);
    ANSWERS(no_hit_ends, ended_if(in, isinf(in->farthest), waiting(in)),
            "that is as if the search ended while a ray has no hit yet: INFINITY is farther than "
            "all that waits");
    ANSWERS(none_goes_on, with_end(waiting(in), waiting(in).goes_on || isinf(in->farthest)),
            "where nothing waits the search is over, whether each ray has a hit or not");

    ANSWERS(part_kept, with_part(waiting(in), in->at.t_min, in->at.t_max),
            "that is as if t_min and t_max were not taken from the stack with the node");
    ANSWERS(t_max_kept, with_part(waiting(in), waiting(in).at.t_min, in->at.t_max),
            "that is as if t_max were not taken from the stack with the node");
    ANSWERS(t_min_kept, with_part(waiting(in), in->at.t_min, waiting(in).at.t_max),
            "that is as if t_min were not taken from the stack with the node");
    ANSWERS(ends_at_hit, with_part(waiting(in), waiting(in).at.t_min, in->farthest),
            "the part of the node ends at the farthest hit, also where it ended before: a part "
            "never grows");
    ANSWERS(at_kept, with_leaf(in),
            "*at is still the leaf: the node from the stack is not handed on");
    ANSWERS(stays, with_one_more(waiting(in)),
            "the node is not taken off the stack: it waits still");
    ONLY(oldest, found->goes_on && is_oldest(in, found->at),
         "that is as if the node that waits longest came from the stack first");
    return NO_MORE;
}

// ---- Answers ----------------------------------------------------------------------------------

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

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const NextWaitingAnswer expected = waiting(in);
    return message_new("the farthest hit is at %.9g; %s waiting: your code %s, expected: it %s",
                       in->farthest, stack_words(in).text, next_waiting_words(found).text,
                       next_waiting_words(&expected).text);
}

const Function tile_end_10 = {"tile_waiting", N_TILE_WAITING_INPUTS, sizeof(NextWaitingAnswer),
                              KNOWING(is_right_end, describe, known)};
const Function tile_next_10 = {"tile_waiting", N_TILE_WAITING_INPUTS, sizeof(NextWaitingAnswer),
                               KNOWING(is_right_next, describe, known)};
