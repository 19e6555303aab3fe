// Writing and judging replays (see replay.h).
#include "replay.h"

#include "message.h"
#include "words.h"

#include <stdlib.h>

// ---- Calls --------------------------------------------------------------------------------------

// Do something with call number `number`. Returns 1, or 0 to stop.
typedef int Visit(void *context, ReplayCall call, size_t number);

// Visit all calls of one kind in their order, up to the first that says stop. Returns how many were
// visited to the end.
static size_t visit_all(const Growth *growth, ReplayEach each, Visit *visit, void *context)
{
    size_t n = 0;
    for (u32 i = 0; i < growth->n_nodes; i++) {
        const GrownNode *node = &growth->nodes[i];
        const int is_asked = each == EACH_NODE || node->first_child != 0;
        const int n_sides = !is_asked ? 0 : each >= EACH_CHILD ? 2 : 1;
        for (int side = 0; side < n_sides; side++) {
            const u32 n_ids = each == EACH_ID_OF_A_CHILD ? node->n_ids : 1;
            for (u32 j = 0; j < n_ids; j++) {
                const ReplayCall call = {
                    node, each >= EACH_CHILD ? grown_child(node, side) : NULL,
                    each == EACH_ID_OF_A_CHILD ? growth->ids[node->first_id + j] : 0};
                if (!visit(context, call, n)) {
                    return n;
                }
                n++;
            }
        }
    }
    return n;
}

// What a visit needs.
typedef struct Inputs {
    const Replay *replay;
    const void *job;
    char *inputs;         // to be written,
    const char *answers;  // or to be judged
} Inputs;

static int count(void *context, ReplayCall call, size_t number)
{
    (void)context, (void)call, (void)number;
    return 1;
}

static int write_input(void *context, ReplayCall call, size_t number)
{
    const Inputs *all = context;
    all->replay->input(all->job, call, all->inputs + number * all->replay->input_bytes);
    return 1;
}

static int judge_answer(void *context, ReplayCall call, size_t number)
{
    const Inputs *all = context;
    return all->replay->is_right(all->job, call, all->answers + number * all->replay->answer_bytes);
}

int replay_write(const Replay *replay, const Growth *growth, const void *job, FILE *file)
{
    const size_t n = visit_all(growth, replay->each, count, NULL);
    Inputs all = {.replay = replay, .job = job, .inputs = calloc(n + 1, replay->input_bytes)};
    if (all.inputs == NULL) {
        return -1;
    }
    visit_all(growth, replay->each, write_input, &all);
    const int result = section_write(file, replay->section, all.inputs, n * replay->input_bytes);
    free(all.inputs);
    return result;
}

int replay_is_right(const Replay *replay, const Growth *growth, const void *job,
                    const Sections *answers)
{
    const size_t n = visit_all(growth, replay->each, count, NULL);
    Inputs all = {.replay = replay,
                  .job = job,
                  .answers = sections_find(answers, replay->section, n * replay->answer_bytes)};
    return all.answers != NULL && visit_all(growth, replay->each, judge_answer, &all) == n;
}

// ---- Lists --------------------------------------------------------------------------------------

int guard_is_untouched(const u32 *guard)
{
    int i = 0;
    while (i < REPLAY_GUARD && guard[i] == UNTOUCHED) {
        i++;
    }
    return i == REPLAY_GUARD;
}

int list_is_right(ListCall call, ListKeeps *keeps, const void *job, const u32 *found)
{
    u32 n = 0;
    for (u32 i = 0; i < call.n_ids; i++) {
        if (keeps(job, call.scene, call.ids[i], call.cell) && found[1 + n++] != call.ids[i]) {
            return 0;
        }
    }
    return found[0] == n && guard_is_untouched(found + 1 + call.n_ids);
}

// Write the lists of all leaves, or of all other nodes for both children. Returns 0, or -1.
static int write_lists(const Growth *growth, const char *name, int of_leaves, FILE *file)
{
    ReplayList *lists = calloc(2 * (size_t)growth->n_nodes + 1, sizeof *lists);
    size_t n = 0;
    for (u32 i = 0; lists != NULL && i < growth->n_nodes; i++) {
        const GrownNode *node = &growth->nodes[i];
        const int is_leaf = node->first_child == 0;
        for (int time = 0; is_leaf == of_leaves && time < (is_leaf ? 1 : 2); time++) {
            lists[n++] = (ReplayList){node->scene, node->id, node->first_id, node->n_ids};
        }
    }
    const int result = lists == NULL ? -1
                                     : section_write(file, "replay.ids", growth->ids,
                                                     growth->n_ids * sizeof *growth->ids) |
                                           section_write(file, name, lists, n * sizeof *lists);
    free(lists);
    return result;
}

int replay_write_lists(const Growth *growth, FILE *file)
{
    return write_lists(growth, "replay.lists", 0, file);
}

// How many entries all answers have together.
static size_t n_answered(const Growth *growth)
{
    size_t n = 0;
    for (u32 i = 0; i < growth->n_nodes; i++) {
        const GrownNode *node = &growth->nodes[i];
        n += node->first_child != 0 ? 2 * REPLAY_ROOM(node->n_ids) : 0;
    }
    return n;
}

int replay_lists_are_right(const Growth *growth, const Sections *answers, ListKeeps *keeps,
                           const void *job)
{
    const u32 *found = sections_find(answers, "replay.lists", n_answered(growth) * sizeof *found);
    int is_right = found != NULL;
    for (u32 i = 0; is_right && i < growth->n_nodes; i++) {
        const GrownNode *node = &growth->nodes[i];
        for (int side = 0; is_right && node->first_child != 0 && side < 2; side++) {
            const ListCall call = {node->scene, growth->ids + node->first_id, node->n_ids,
                                   grown_child(node, side)->cell};
            is_right = list_is_right(call, keeps, job, found);
            found += REPLAY_ROOM(node->n_ids);
        }
    }
    return is_right;
}

// ---- Leaves -------------------------------------------------------------------------------------

int replay_write_leaves(const Growth *growth, const ReplayTree *trees, u32 n_scenes, FILE *file)
{
    return write_lists(growth, "replay.leaves", 1, file) |
           section_write(file, "replay.trees", trees, n_scenes * sizeof *trees);
}
