// What the 3D bench says of scenes that move (see report_moving.h).
//
// A round has a median of each time; sums, ratios and crossings are made of those, round by round,
// and what is printed is their median with the smallest and the largest.
// Read next: bench3d-moving.gnuplot.
#include "report_moving.h"

#include "output_file.h"
#include "path.h"

#include <math.h>
#include <stdio.h>

// What takes time when spheres move.
typedef enum Part {
    BUILD,   // the tree
    WHOLE,   // the tree, its copy to the device, and the picture
    BUDGET,  // nothing is measured: what there is for a frame
} Part;

typedef struct Quantity {
    Part part;
    Renderer renderer;
    double frames_a_second;  // of a BUDGET
} Quantity;

static int has_tree(Renderer renderer)
{
    return renderer != NAIVE;
}

// Milliseconds of a quantity in a round.
static double round_ms(const Case3D *bench_case, Quantity quantity, int round)
{
    const Renderer renderer = quantity.renderer;
    if (quantity.part == BUDGET) {
        return 1e3 / quantity.frames_a_second;
    }
    const double build_ms =
        has_tree(renderer) ? bench_case->builds[renderer].round_median_ms[round] : 0;
    const double copy_ms =
        has_tree(renderer) ? bench_case->copies[renderer].round_median_ms[round] : 0;
    return quantity.part == BUILD
               ? build_ms
               : build_ms + copy_ms + bench_case->frames[renderer].round_median_ms[round];
}

static int n_rounds(const Case3D *bench_case)
{
    return bench_case->frames[NAIVE].n_rounds;
}

static Spread spread_of_quantity(const Case3D *bench_case, Quantity quantity)
{
    double ms[SERIES_MAX_ROUNDS] = {0};
    for (int round = 0; round < n_rounds(bench_case); round++) {
        ms[round] = round_ms(bench_case, quantity, round);
    }
    return spread_of(ms, n_rounds(bench_case));
}

static Spread ratio_of(const Case3D *bench_case, Quantity dividend, Quantity divisor)
{
    double ratios[SERIES_MAX_ROUNDS] = {0};
    for (int round = 0; round < n_rounds(bench_case); round++) {
        ratios[round] =
            round_ms(bench_case, dividend, round) / round_ms(bench_case, divisor, round);
    }
    return spread_of(ratios, n_rounds(bench_case));
}

// ---- Crossings ------------------------------------------------------------------------------

// For which numbers of spheres does one quantity take longer than another?
typedef struct Question {
    const char *answer;  // what is then so
    Quantity longer, shorter;
} Question;

#define MOVING(renderer) {WHOLE, renderer, 0}
#define BUILDING(renderer) {BUILD, renderer, 0}
#define FRAME_OF(frames_a_second) {BUDGET, NAIVE, frames_a_second}

static const Question QUESTIONS[] = {
    {"lab 06's tree and lab 07's kernel are quicker than the naive kernel", MOVING(NAIVE),
     MOVING(KDTREE)},
    {"lab 08's tree and lab 07's kernel are quicker than the naive kernel", MOVING(NAIVE),
     MOVING(BY_COST)},
    {"lab 10's tiles are quicker than the naive kernel", MOVING(NAIVE), MOVING(TILES)},
    {"for lab 07's kernel lab 06's tree is the better one", MOVING(BY_COST), MOVING(KDTREE)},
    {"building lab 06's tree takes longer than 1/60 s", BUILDING(KDTREE), FRAME_OF(60)},
    {"building lab 06's tree takes longer than 1/15 s", BUILDING(KDTREE), FRAME_OF(15)},
    {"building lab 08's tree takes longer than 1/60 s", BUILDING(BY_COST), FRAME_OF(60)},
    {"building lab 08's tree takes longer than 1/15 s", BUILDING(BY_COST), FRAME_OF(15)},
    {"a whole frame of lab 10's tiles takes longer than 1/60 s", MOVING(TILES), FRAME_OF(60)},
    {"a whole frame of lab 10's tiles takes longer than 1/15 s", MOVING(TILES), FRAME_OF(15)},
};
enum { N_QUESTIONS = sizeof QUESTIONS / sizeof *QUESTIONS };

// Numbers of spheres from `from` to `to`. From INFINITY: there are none; to INFINITY: to the most
// that were measured.
typedef struct Span {
    double from, to;
} Span;

static double ratio_in(const Case3D *bench_case, const Question *question, int round)
{
    return round_ms(bench_case, question->longer, round) /
           round_ms(bench_case, question->shorter, round);
}

// Between two cases, where is the ratio 1? On the straight line between them, where both axes are
// logarithmic.
static double crossing(const Case3D *left, const Case3D *right, const Question *question, int round)
{
    const double before = log(ratio_in(left, question, round));
    const double after = log(ratio_in(right, question, round));
    const double n_left = left->scene.n_spheres, n_right = right->scene.n_spheres;
    return n_left * pow(n_right / n_left, before / (before - after));
}

// The longer of two spans, by their ends' ratio; the one from INFINITY is the shortest of all.
static Span longer_of(Span a, Span b)
{
    return b.to / b.from > a.to / a.from || isinf(a.from) ? b : a;
}

// The answer of one round. Where there are several spans, as of times that hardly differ, the
// longest one counts.
static Span span_in(const Case3D *cases, int n_cases, const Question *question, int round)
{
    Span longest = {INFINITY, INFINITY}, span = longest;
    const Case3D *last = NULL;
    int was_longer = 0;
    for (int i = 0; i < n_cases; i++) {
        const Case3D *bench_case = &cases[i];
        if (!case3d_is_random(bench_case)) {
            continue;
        }
        const int is_longer = ratio_in(bench_case, question, round) > 1;
        if (is_longer && !was_longer) {
            span.from = last != NULL ? crossing(last, bench_case, question, round)
                                     : bench_case->scene.n_spheres;
        } else if (!is_longer && was_longer) {
            span.to = crossing(last, bench_case, question, round);
            longest = longer_of(longest, span);
        }
        was_longer = is_longer;
        last = bench_case;
    }
    if (was_longer) {
        span.to = last->scene.n_spheres;
        longest = longer_of(longest, span);
    }
    // Nobody knows where it ends that lasts to the end.
    longest.to = was_longer && longest.to == span.to ? INFINITY : longest.to;
    return longest;
}

// A number of spheres with two digits, as more would say what was not measured.
static void print_number(double n, const char *infinite)
{
    if (isinf(n)) {
        printf("%s", infinite);
    } else {
        const double unit = pow(10, floor(log10(n)) - 1);
        printf("%.10g", round(n / unit) * unit);
    }
}

static void print_spread(Spread spread, const char *infinite)
{
    print_number(spread.median, infinite);
    printf("  (single rounds: ");
    print_number(spread.min, infinite);
    printf(" to ");
    print_number(spread.max, infinite);
    printf(")");
}

static void print_answer(const Case3D *cases, int n_cases, const Question *question)
{
    double from[SERIES_MAX_ROUNDS] = {0}, to[SERIES_MAX_ROUNDS] = {0};
    const int n = n_rounds(&cases[0]);
    for (int round = 0; round < n; round++) {
        const Span span = span_in(cases, n_cases, question, round);
        from[round] = span.from;
        to[round] = span.to;
    }
    const Spread first = spread_of(from, n), last = spread_of(to, n);
    printf("  %s: ", question->answer);
    if (isinf(first.median)) {
        printf("with no number that was measured\n");
        return;
    }
    printf("from ");
    print_spread(first, "none");
    if (!isinf(last.median)) {
        printf(" to ");
        print_spread(last, "the end");
    }
    printf("\n");
}

// ---- Tables ---------------------------------------------------------------------------------

static const struct Way {
    Renderer renderer;
    const char *name;   // in the CSV file
    const char *title;  // of its table
} WAYS[] = {
    {NAIVE, "naive", NULL},
    {KDTREE, "kdtree", "lab 06's tree, lab 07's kernel"},
    {BY_COST, "bycost", "lab 08's tree, lab 07's kernel"},
    {TILES, "tiles", "lab 08's tree in larger leaves, lab 10's tiles"},
};
enum { N_WAYS = sizeof WAYS / sizeof *WAYS };

static void print_way(const Case3D *cases, int n_cases, const struct Way *way)
{
    const Quantity naive = MOVING(NAIVE), moving = MOVING(way->renderer);
    printf("  %s\n", way->title);
    printf("  %9s  %10s  %10s  %10s  %10s  %10s  %s\n", "spheres", "naive", "build", "copy", "draw",
           "all three", "naive / all three  (single rounds)");
    for (int i = 0; i < n_cases; i++) {
        const Case3D *bench_case = &cases[i];
        if (!case3d_is_random(bench_case)) {
            continue;
        }
        const Spread ratio = ratio_of(bench_case, naive, moving);
        printf("  %9d  %10.2f  %10.3f  %10.3f  %10.2f  %10.2f  %17.3g  (%.3g to %.3g)\n",
               bench_case->scene.n_spheres, spread_of_quantity(bench_case, naive).median,
               series_median(&bench_case->builds[way->renderer]),
               series_median(&bench_case->copies[way->renderer]),
               series_median(&bench_case->frames[way->renderer]),
               spread_of_quantity(bench_case, moving).median, ratio.median, ratio.min, ratio.max);
    }
}

void report_moving_print(const Case3D *cases, int n_cases)
{
    printf("\nMoving scenes: random spheres, and their tree built anew for each frame of %dx%d "
           "pixels, on one thread;\nmilliseconds\n",
           CASE3D_SIDE, CASE3D_SIDE);
    for (int i = 0; i < N_WAYS; i++) {
        if (has_tree(WAYS[i].renderer)) {
            print_way(cases, n_cases, &WAYS[i]);
        }
    }
    printf("\nFor which numbers of moving spheres it is so that\n");
    for (int i = 0; i < N_QUESTIONS; i++) {
        print_answer(cases, n_cases, &QUESTIONS[i]);
    }
}

// ---- For the plot ---------------------------------------------------------------------------

static void write_row(FILE *file, const Case3D *bench_case, const struct Way *way)
{
    const Renderer renderer = way->renderer;
    const Quantity naive = MOVING(NAIVE), moving = MOVING(renderer);
    const Spread ms = spread_of_quantity(bench_case, moving);
    const Spread ratio = ratio_of(bench_case, naive, moving);
    fprintf(file, "%s,%d,", way->name, bench_case->scene.n_spheres);
    if (has_tree(renderer)) {
        fprintf(file, "%.4f,%.4f,", series_median(&bench_case->builds[renderer]),
                series_median(&bench_case->copies[renderer]));
    } else {
        fprintf(file, ",,");
    }
    fprintf(file, "%.4f,%.4f,%.4f,%.4f,%.6g,%.6g,%.6g\n",
            series_median(&bench_case->frames[renderer]), ms.median, ms.min, ms.max, ratio.median,
            ratio.min, ratio.max);
}

int report_moving_write_csv(const Case3D *cases, int n_cases, const char *folder)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(path, "%s/bench3d-moving.csv", folder);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fprintf(output.file, "renderer,n_spheres,build_ms,copy_ms,draw_ms,median_ms,min_ms,max_ms,"
                         "ratio,min_ratio,max_ratio\n");
    for (int way = 0; way < N_WAYS; way++) {
        for (int i = 0; i < n_cases; i++) {
            if (case3d_is_random(&cases[i])) {
                write_row(output.file, &cases[i], &WAYS[way]);
            }
        }
    }
    if (output_file_commit(&output) != 0) {
        return -1;
    }
    printf("Those of moving scenes: %s\n", path);
    return 0;
}
