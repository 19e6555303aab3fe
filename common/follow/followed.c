// Following a pixel, and comparing (see followed.h).
//
// Read next: followed_text.c.
#include "followed.h"

#include "record.h"
#include "reference.h"

#include <math.h>

const Step *followed_step(const Steps *steps, u32 i)
{
    return i < steps_kept(steps->n_steps) ? &steps->steps[i] : NULL;
}

int followed_is_hit(const World *world, const Step *step)
{
    return world->kind == &CIRCLES ? step->answer > 0 : isfinite(step->answer);
}

u32 followed_waiting(const Steps *steps, u32 i, StepWaiting waiting[TODO_SIZE])
{
    for (u32 n = 0; n < TODO_SIZE; n++) {
        waiting[n] = (StepWaiting){NO_ID, NAN, NAN};
    }
    u32 n_waiting = 0;
    // What lies deeper was on top before.
    for (u32 k = 0; k <= i && k < steps_kept(steps->n_steps); k++) {
        const Step *step = &steps->steps[k];
        if (step->kind != STEP_NODE && step->kind != STEP_LEAF) {
            continue;
        }
        n_waiting = step->n_waiting < TODO_SIZE ? step->n_waiting : TODO_SIZE;
        for (u32 top = 0; top < MAX_STEP_WAITING && top < n_waiting; top++) {
            waiting[n_waiting - 1 - top] = step->waiting[top];
        }
    }
    return n_waiting;
}

// ---- Where two part -----------------------------------------------------------------------------

static int is_near(f32 found, f32 expected, f32 slack)
{
    return found == expected || fabsf(found - expected) <= slack ||
           (isnan(found) && isnan(expected));
}

static int is_same_visit(const Step *own, const Step *right)
{
    if (own->n_waiting != right->n_waiting || !is_near(own->t_min, right->t_min, right->slack) ||
        !is_near(own->t_max, right->t_max, right->slack)) {
        return 0;
    }
    for (u32 k = 0; k < MAX_STEP_WAITING && k < right->n_waiting; k++) {
        const StepWaiting *a = &own->waiting[k], *b = &right->waiting[k];
        if (a->node != b->node || !is_near(a->t_min, b->t_min, right->slack) ||
            !is_near(a->t_max, b->t_max, right->slack)) {
            return 0;
        }
    }
    if (own->kind == STEP_LEAF) {
        return 1;
    }
    return own->side == right->side && own->met == right->met &&
           (right->met != MET_BOTH || is_near(own->t_split, right->t_split, right->slack));
}

// An end is the same when the same sphere is hit at the same place, or the colour is the same.
static int is_same_end(const World *world, const Step *own, const Step *right)
{
    if (world->kind != &CIRCLES) {
        return is_near(own->nearest, right->nearest, right->slack);
    }
    for (int channel = 0; channel < 4; channel++) {
        if (own->element[channel] != right->element[channel]) {
            return 0;
        }
    }
    return 1;
}

static int is_same(const World *world, const Step *own, const Step *right)
{
    if (own->kind != right->kind || own->id != right->id) {
        return 0;
    }
    switch (own->kind) {
    case STEP_TEST:
        return followed_is_hit(world, own) == followed_is_hit(world, right) &&
               is_near(own->answer, right->answer, right->slack);
    case STEP_END:
        return is_same_end(world, own, right);
    default:
        return world->kind == &CIRCLES || is_same_visit(own, right);
    }
}

static void compare(Followed *followed)
{
    const Steps *own = &followed->own, *right = &followed->reference;
    followed->parting = -1;
    if (right->n_steps == 0) {
        return;
    }
    const u32 n_own = steps_kept(own->n_steps), n_right = steps_kept(right->n_steps);
    for (u32 i = 0; i < n_own || i < n_right; i++) {
        if (i >= n_own || i >= n_right ||
            !is_same(followed->world, &own->steps[i], &right->steps[i])) {
            followed->parting = (int)i;
            followed->is_close = (i > 0 && i <= n_right && right->steps[i - 1].is_close) ||
                                 (i < n_right && right->steps[i].is_close);
            return;
        }
    }
}

// ---- Following ----------------------------------------------------------------------------------

// What the earlier lab's kernel, which asks every element, ends with: it is in every handout.
static int follow_naive(Followed *followed, const WorldKernel *kernel)
{
    Steps *steps = world_allocate(sizeof *steps);
    const int result = record_pixel(followed->world, kernel, followed->x, followed->y, steps);
    if (result == 0) {
        followed->naive_label = kernel->label;
        followed->naive_end = steps->steps[steps_kept(steps->n_steps) - 1];
    }
    free(steps);
    return result;
}

int followed_make(Followed *followed, const World *world, const WorldLab *world_lab, int x, int y)
{
    *followed = (Followed){.world = world, .x = x, .y = y};
    if (record_pixel(world, &world_lab->kernels[0], x, y, &followed->own) != 0) {
        return -1;
    }
    const int last = world_lab->n_kernels - 1;
    if (last > 0 && follow_naive(followed, &world_lab->kernels[last]) != 0) {
        return -1;
    }
    if (reference_follow(world, x, y, &followed->reference) != 0) {
        followed->reference.n_steps = 0;
    }
    compare(followed);
    return 0;
}
