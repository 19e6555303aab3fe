// Lab 07: each answer alone, on the sections that the whole job has for it. Only next_child needs
// other tasks, for which there are stand-ins. Whole scenes need all tasks; in their place stand all
// inputs of next_child or next_waiting, which depend on nothing else.
#include "judge_07.h"

#include <string.h>

static int write_leaves(const Inputs07 *inputs, FILE *file)
{
    int result = section_write(file, "leaves", inputs->leaves, sizeof inputs->leaves);
    result |= section_write(file, "leaf_ids", inputs->leaf_ids, sizeof inputs->leaf_ids);
    return result |
           section_write(file, "leaf_spheres", inputs->leaf_spheres, sizeof inputs->leaf_spheres);
}

int alone_07_write(const void *pointer, const char *task, FILE *file)
{
    const Job07 *job = pointer;
    const Inputs07 *inputs = &job->inputs;
    if (strcmp(task, "clip_to_box") == 0) {
        return section_write(file, "clips", inputs->clips, sizeof inputs->clips);
    }
    if (strcmp(task, "near_side") == 0) {
        return section_write(file, "sides", inputs->sides, sizeof inputs->sides);
    }
    if (strcmp(task, "children_on_ray") == 0) {
        return section_write(file, "planes", inputs->planes, sizeof inputs->planes);
    }
    if (strcmp(task, "search_leaf") == 0) {
        return write_leaves(inputs, file);
    }
    if (strcmp(task, "next_child") == 0) {
        return section_write(file, "next_child", inputs->children, sizeof inputs->children);
    }
    return section_write(file, "next_waiting", inputs->waiting, sizeof inputs->waiting);
}

int alone_07_passes(const void *pointer, int check, const Sections *answers)
{
    const Job07 *job = pointer;
    switch (check) {
    case CHILD_ONE:
        return inputs_07_pass_children(&job->inputs, ONE_MET, answers);
    case CHILD_BOTH:
        return inputs_07_pass_children(&job->inputs, BOTH_MET, answers);
    case TRACE_RANDOM:
    case TRACE_PICTURE:
        return inputs_07_pass_children(&job->inputs, ONE_MET | BOTH_MET, answers);
    case TRACE_EDGES:
    case TRACE_WORK:
        return verdict_passes(judge_07_check(job, WAITING_END, answers)) &&
               verdict_passes(judge_07_check(job, WAITING_NEXT, answers));
    default:
        return verdict_passes(judge_07_check(job, check, answers));
    }
}
