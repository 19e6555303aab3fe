// A followed pixel in words (see panel_lines.h).
//
// Called by view.c.
#include "panel_lines.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void visit_write(const World *world, const Step *step, PanelLine *line)
{
    const char *what = step->kind == STEP_LEAF ? "leaf" : "node";
    if (world->kind == &CIRCLES) {
        snprintf(line->text, sizeof line->text, "%s %u", what, step->id);
    } else {
        snprintf(line->text, sizeof line->text, "%s %u: t %.4g to %.4g, %u wait", what, step->id,
                 step->t_min, step->t_max, step->n_waiting);
    }
}

static void end_write(const World *world, const Step *step, PanelLine *line)
{
    if (world->kind == &CIRCLES) {
        char leaf[32] = "";
        if (step->id != NO_ID) {
            snprintf(leaf, sizeof leaf, "leaf %u, ", step->id);
        }
        snprintf(line->text, sizeof line->text, "%scolour %.3g %.3g %.3g", leaf, step->element[0],
                 step->element[1], step->element[2]);
    } else if (isfinite(step->nearest)) {
        snprintf(line->text, sizeof line->text, "hit: sphere %u, t %.6g", step->id, step->nearest);
    } else {
        snprintf(line->text, sizeof line->text, "hit: none");
    }
}

static int is_hit(const World *world, const Step *step)
{
    return world->kind == &CIRCLES ? step->answer > 0 : isfinite(step->answer);
}

// Write an element that was asked in vain, behind the ones of the line before where there is room.
// Returns how many lines were added.
static int miss_write(u32 id, PanelLine *line, PanelLine *before)
{
    if (before != NULL && before->lists_missed) {
        const size_t length = strlen(before->text);
        char number[16];
        snprintf(number, sizeof number, " %u", id);
        if (length + strlen(number) <= PANEL_LINE_LENGTH) {
            strcpy(before->text + length, number);
            return 0;
        }
    }
    snprintf(line->text, sizeof line->text, "  missed: %u", id);
    line->lists_missed = 1;
    return 1;
}

// Returns how many lines were added.
static int test_write(const World *world, const Step *step, PanelLine *line, PanelLine *before)
{
    if (!is_hit(world, step)) {
        return miss_write(step->id, line, before);
    }
    if (world->kind == &CIRCLES) {
        snprintf(line->text, sizeof line->text, "  circle %u: nearest so far", step->id);
    } else {
        snprintf(line->text, sizeof line->text, "  sphere %u: t %.6g", step->id, step->answer);
    }
    return 1;
}

int panel_lines(const World *world, const Steps *steps, PanelLine *lines)
{
    int n_lines = 0;
    for (u32 i = 0; i < steps_kept(steps->n_steps); i++) {
        const Step *step = &steps->steps[i];
        PanelLine *line = &lines[n_lines];
        line->lists_missed = 0;
        if (step->kind == STEP_TEST) {
            n_lines += test_write(world, step, line, n_lines > 0 ? line - 1 : NULL);
            continue;
        }
        if (step->kind == STEP_END && steps->n_steps > MAX_STEPS) {
            snprintf(line->text, sizeof line->text, "and %u more", steps->n_steps - MAX_STEPS);
            line = &lines[++n_lines];
        }
        if (step->kind == STEP_END) {
            end_write(world, step, line);
        } else {
            visit_write(world, step, line);
        }
        n_lines++;
    }
    return n_lines;
}
