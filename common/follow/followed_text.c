// A followed pixel in words (see followed.h).
//
// Read next: followed_json.c.
#include "followed.h"

#include "message.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

// A line is as wide as a column.
enum { COLUMN = 62 };

__attribute__((format(printf, 2, 3))) static void add_line(StepWords *words, const char *format,
                                                           ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words->lines[words->n++], STEP_LINE_BYTES, format, arguments);
    va_end(arguments);
}

// ---- One step -----------------------------------------------------------------------------------

// In 2D: the node's cell, and of an inner node its children's.
static void cell_tell(const World *world, const Step *step, StepWords *words)
{
    const KdTree2D *tree = world->kind->data(world).tree2d;
    if (step->id >= tree->n_nodes) {
        add_line(words, "node %u, which the tree does not have", step->id);
        return;
    }
    const BBox2D box = tree->nodes_BBox[step->id];
    const NodeRel node = tree->nodes_Relations[step->id];
    add_line(words, "%s %u: x [%g, %g), y [%g, %g)", step->kind == STEP_LEAF ? "leaf" : "node",
             step->id, box.minX, box.maxX, box.minY, box.maxY);
    if (step->kind == STEP_LEAF) {
        const u32 n_circles = tree->mapNode2Circles[node.circleMapOffset];
        add_line(words, "  %u circle%s, from offset %u on", n_circles, plural(n_circles),
                 node.circleMapOffset);
    } else {
        const BBox2D left = tree->nodes_BBox[node.lChild];
        add_line(words, "  left child %u: x [%g, %g), y [%g, %g); right %u", node.lChild, left.minX,
                 left.maxX, left.minY, left.maxY, node.rChild);
    }
}

// What waits on the stack, the nearest first, as far as there is room.
static void waiting_tell(const Steps *steps, u32 i, StepWords *words)
{
    StepWaiting waiting[TODO_SIZE];
    const u32 n_waiting = followed_waiting(steps, i, waiting);
    if (n_waiting == 0) {
        return;
    }
    char line[STEP_LINE_BYTES];
    int length = snprintf(line, sizeof line, "  waiting:");
    for (u32 k = 0; k < n_waiting; k++) {
        const StepWaiting *entry = &waiting[n_waiting - 1 - k];
        char text[48];
        const int more = snprintf(text, sizeof text, "%s %u [%.4g, %.4g]", k > 0 ? "," : "",
                                  entry->node, entry->t_min, entry->t_max);
        if (length + more > COLUMN - 12) {
            length += snprintf(line + length, sizeof line - (size_t)length, " and %u more",
                               n_waiting - k);
            break;
        }
        length += snprintf(line + length, sizeof line - (size_t)length, "%s", text);
    }
    add_line(words, "%s", line);
}

// In 3D: the node's plane, its part of the ray, and what is decided.
static void plane_tell(const World *world, const Steps *steps, u32 i, StepWords *words)
{
    static const char *const MET[] = {"the near one", "the far one", "both, far waits"};
    const Step *step = &steps->steps[i];
    const KdTree3D *tree = world->kind->data(world).tree3d;
    if (step->id >= tree->n_nodes) {
        add_line(words, "node %u, which the tree does not have", step->id);
        return;
    }
    const KdNode3 node = tree->nodes[step->id];
    if (step->kind == STEP_LEAF) {
        add_line(words, "leaf %u: t %.5g to %.5g, %u sphere%s", step->id, step->t_min, step->t_max,
                 node.n_spheres, plural(node.n_spheres));
    } else {
        add_line(words, "node %u: %c = %g, t %.5g to %.5g", step->id, "xyz?"[node.split_axis & 3],
                 node.split_pos, step->t_min, step->t_max);
        char t_split[32] = "";
        if (step->met == MET_BOTH) {
            snprintf(t_split, sizeof t_split, "t_split %.5g, ", step->t_split);
        }
        add_line(words, "  %snear %u, far %u: %s", t_split, node.first + (step->side != 0),
                 node.first + (step->side == 0), step->met <= MET_BOTH ? MET[step->met] : "?");
    }
    waiting_tell(steps, i, words);
}

static void test_tell(const World *world, const Step *step, StepWords *words)
{
    const char *what = world->kind == &CIRCLES ? "circle" : "sphere";
    char name[32];
    snprintf(name, sizeof name, step->id == NO_ID ? "  a %s that is not the scene's" : "  %s %u",
             what, step->id);
    if (!followed_is_hit(world, step)) {
        add_line(words, "%s: %s", name, world->kind == &CIRCLES ? "no" : "missed");
    } else if (world->kind == &CIRCLES) {
        add_line(words, "%s: nearest so far, depth %g", name, step->element[3]);
    } else {
        add_line(words, "%s: t %.6g", name, step->answer);
    }
}

static void end_tell(const World *world, const Step *step, StepWords *words)
{
    if (world->kind == &CIRCLES) {
        add_line(words, "colour: %.4g %.4g %.4g %.4g", step->element[0], step->element[1],
                 step->element[2], step->element[3]);
    } else if (isfinite(step->nearest)) {
        add_line(words, "hit: sphere %u, t %.6g", step->id, step->nearest);
    } else {
        add_line(words, "hit: none");
    }
}

StepWords followed_words(const World *world, const Steps *steps, u32 i)
{
    StepWords words = {.n = 0};
    const Step *step = followed_step(steps, i);
    if (step == NULL) {
        return words;
    }
    if (step->kind == STEP_TEST) {
        test_tell(world, step, &words);
    } else if (step->kind == STEP_END) {
        if (steps->n_steps > MAX_STEPS) {
            add_line(&words, "... %u steps that were not kept", steps->n_steps - MAX_STEPS);
        }
        end_tell(world, step, &words);
    } else if (world->kind == &CIRCLES) {
        cell_tell(world, step, &words);
    } else {
        plane_tell(world, steps, i, &words);
    }
    return words;
}

// ---- All steps ----------------------------------------------------------------------------------

// The number of the step stands in front of its first line only.
static void number_print(u32 i, int line, FILE *file)
{
    if (line == 0) {
        fprintf(file, "%4u  ", i);
    } else {
        fprintf(file, "      ");
    }
}

static void print_alone(const World *world, const Steps *steps, u32 from, u32 to, FILE *file)
{
    for (u32 i = from; i < to; i++) {
        const StepWords words = followed_words(world, steps, i);
        for (int line = 0; line < words.n; line++) {
            number_print(i, line, file);
            fprintf(file, "%s\n", words.lines[line]);
        }
    }
}

static void print_beside(const Followed *followed, u32 from, FILE *file)
{
    const u32 n_own = steps_kept(followed->own.n_steps);
    const u32 n_right = steps_kept(followed->reference.n_steps);
    fprintf(file, "      %-*s | %s\n", COLUMN, "your kernel", "the reference");
    for (u32 i = from; i < n_own || i < n_right; i++) {
        const StepWords own = followed_words(followed->world, &followed->own, i);
        const StepWords right = followed_words(followed->world, &followed->reference, i);
        for (int line = 0; line < own.n || line < right.n; line++) {
            number_print(i, line, file);
            fprintf(file, "%-*s |", COLUMN, line < own.n ? own.lines[line] : "");
            fprintf(file, line < right.n ? " %s\n" : "%s\n",
                    line < right.n ? right.lines[line] : "");
        }
    }
}

static void head_print(const Followed *followed, FILE *file)
{
    const World *world = followed->world;
    fprintf(file, "%s, %s, %d x %d: pixel %d, %d\n", world->lab->name, world->lab->options.scene,
            world->width, world->height, followed->x, followed->y);
    if (world->kind != &CIRCLES) {
        const f32 *o = followed->own.origin, *d = followed->own.direction;
        fprintf(file, "ray from (%.6g, %.6g, %.6g), direction (%.6g, %.6g, %.6g)\n", o[0], o[1],
                o[2], d[0], d[1], d[2]);
    }
}

static void count_print(const World *world, const char *who, const Steps *steps, FILE *file)
{
    fprintf(file, "%s: %u test%s, %u node%s", who, steps->n_tests, plural(steps->n_tests),
            steps->n_nodes_visited, plural(steps->n_nodes_visited));
    if (world->kind != &CIRCLES) {
        fprintf(file, ", %u lea%s, at most %u waiting", steps->n_leaves_visited,
                steps->n_leaves_visited == 1 ? "f" : "ves", steps->stack_depth);
    }
    fprintf(file, "\n");
}

void followed_print(const Followed *followed, FILE *file)
{
    const World *world = followed->world;
    const u32 n_own = steps_kept(followed->own.n_steps);
    head_print(followed, file);
    if (followed->parting < 0) {
        print_alone(world, &followed->own, 0, n_own, file);
    } else {
        print_alone(world, &followed->own, 0, (u32)followed->parting, file);
        print_beside(followed, (u32)followed->parting, file);
    }
    count_print(world, "your kernel", &followed->own, file);
    if (followed->naive_label != NULL) {
        StepWords words = {.n = 0};
        end_tell(world, &followed->naive_end, &words);
        fprintf(file, "the %s kernel, which asks all %d %s: %s\n", followed->naive_label,
                world->n_elements, world->kind->elements, words.lines[0]);
    }
    if (followed->reference.n_steps == 0) {
        return;
    }
    count_print(world, "the reference", &followed->reference, file);
    if (followed->parting < 0) {
        fprintf(file, "they do the same in all %u steps\n", followed->own.n_steps);
    } else {
        fprintf(file, "they part at step %d%s\n", followed->parting,
                followed->is_close ? ", where rounding decides: both may be right" : "");
    }
}
