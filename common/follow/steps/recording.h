// Included before a lab's kernel, in the place of kernels/work.h: a pixel's Work is then the list
// of its steps. The files beside this one say what count_test() and the like write into it.
//
// Read next: 07-kdtree-3d-trace.cl.
#ifndef FOLLOW_RECORDING_H
#define FOLLOW_RECORDING_H

#include "steps.h"

#define KERNELS_WORK_H
typedef Steps Work;

// Kernels begin with Work work = {0, 0, 0, 0}: what is more is 0, too, and no mistake.
#ifdef __has_warning
#if __has_warning("-Wmissing-field-initializers")
#pragma clang diagnostic ignored "-Wmissing-field-initializers"
#endif
#endif

static inline void step_add(Work *work, Step step)
{
    work->n_tests += step.kind == STEP_TEST;
    work->n_nodes_visited += step.kind == STEP_NODE;
    work->n_leaves_visited += step.kind == STEP_LEAF;
    // The last one is always kept: it says how the pixel ended.
    if (work->n_steps < MAX_STEPS || step.kind == STEP_END) {
        work->steps[min(work->n_steps, (uint)MAX_STEPS - 1)] = step;
    }
    work->n_steps++;
}

// Ask again all that was asked, for the answers: `ask` is an expression with `step` in it. What is
// written down meanwhile is forgotten.
#define ANSWER_ALL(work, ask)                                                                      \
    do {                                                                                           \
        const uint n_steps = (work)->n_steps, n_tests = (work)->n_tests;                           \
        for (uint i = 0; i < steps_kept(n_steps); i++) {                                           \
            const Step step = (work)->steps[i];                                                    \
            if (step.kind == STEP_TEST) {                                                          \
                (work)->steps[i].answer = (ask);                                                   \
            }                                                                                      \
            (work)->n_steps = n_steps;                                                             \
            (work)->n_tests = n_tests;                                                             \
        }                                                                                          \
    } while (0)

#endif
