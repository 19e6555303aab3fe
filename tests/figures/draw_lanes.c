// 10-divergence.svg: 32 neighbouring rays in step, as a GPU runs them: who works, who waits.
#include "figures3d.h"

#include "record.h"

// A row of lanes and its columns, in pixels.
enum { N_LANES = 32, LEFT = 66, RIGHT = 1008, TOP = 92, LANE = 11, MAX_TURNS = 400 };
enum { BOTTOM = TOP + N_LANES * LANE, HEIGHT = BOTTOM + 146 };

// What a lane does in one turn of the loop of trace(): a step at an inner node, or a leaf with so
// many tests; then nothing, when its ray is done.
typedef struct Turn {
    int is_leaf;
    int n_tests;
} Turn;

typedef struct Lane {
    Turn turns[MAX_TURNS];
    int n_turns;
} Lane;

static Lane lane_of(const Steps *steps)
{
    Lane lane = {.n_turns = 0};
    for (u32 i = 0; i < steps_kept(steps->n_steps); i++) {
        const Step *step = &steps->steps[i];
        if (step->kind == STEP_TEST) {
            lane.turns[lane.n_turns - 1].n_tests++;
        } else if (step->kind != STEP_END && lane.n_turns < MAX_TURNS) {
            lane.turns[lane.n_turns++] = (Turn){.is_leaf = step->kind == STEP_LEAF};
        }
    }
    return lane;
}

// One column for all lanes: those whose turn it is work, and the others wait or are done.
typedef enum Doing { WAITS, AT_NODE, ASKS, IS_DONE } Doing;

typedef struct Columns {
    Doing doing[N_LANES][2 * MAX_TURNS];
    int n;
    int n_busy;  // entries in which a lane works
} Columns;

// Add the column in which the lanes of turn number `turn` do one thing: their node's step, or, at
// a leaf, test number `test`. Without one that does, there is none.
static void column_add(Columns *columns, const Lane *lanes, int turn, int is_leaf, int test)
{
    int n_busy = 0;
    for (int i = 0; i < N_LANES; i++) {
        const Lane *lane = &lanes[i];
        Doing doing = turn < lane->n_turns ? WAITS : IS_DONE;
        if (doing == WAITS && lane->turns[turn].is_leaf == is_leaf &&
            (!is_leaf || test < lane->turns[turn].n_tests)) {
            doing = is_leaf ? ASKS : AT_NODE;
            n_busy++;
        }
        columns->doing[i][columns->n] = doing;
    }
    columns->n_busy += n_busy;
    columns->n += n_busy > 0;
}

// The lanes in step: in each turn first the nodes, then the leaves, test by test.
static Columns in_step(const Lane *lanes)
{
    Columns columns = {.n = 0};
    int n_turns = 0;
    for (int i = 0; i < N_LANES; i++) {
        n_turns = lanes[i].n_turns > n_turns ? lanes[i].n_turns : n_turns;
    }
    for (int turn = 0; turn < n_turns; turn++) {
        column_add(&columns, lanes, turn, 0, 0);
        int n_before;
        int test = 0;
        do {
            n_before = columns.n;
            column_add(&columns, lanes, turn, 1, test++);
        } while (columns.n > n_before && columns.n < 2 * MAX_TURNS - 2);
    }
    return columns;
}

// The turns in which a lane does one thing: equal neighbours as one box.
static void lane_draw(FILE *file, const Columns *columns, int lane, Doing doing)
{
    const double width = (RIGHT - LEFT) / (double)columns->n;
    for (int from = 0, to; from < columns->n; from = to) {
        for (to = from + 1;
             to < columns->n && columns->doing[lane][to] == columns->doing[lane][from];) {
            to++;
        }
        if (columns->doing[lane][from] == doing) {
            svg_boxes_add(file, LEFT + from * width, TOP + lane * LANE + 0.5, (to - from) * width,
                          LANE - 1);
        }
    }
}

static void columns_draw(FILE *file, const Columns *columns)
{
    static const char *const LOOKS[] = {
        [WAITS] = "fill=\"#ffffff\" stroke=\"#c8c8c8\" stroke-width=\"0.5\"",
        [AT_NODE] = "fill=\"#56b4e9\"",
        [ASKS] = "fill=\"" SVG_BLACK "\"",
        [IS_DONE] = "fill=\"#e0e0e0\"",
    };
    for (Doing doing = WAITS; doing <= IS_DONE; doing++) {
        svg_boxes_begin(file, LOOKS[doing]);
        for (int i = 0; i < N_LANES; i++) {
            lane_draw(file, columns, i, doing);
        }
        svg_boxes_end(file);
    }
}

static void legend_draw(FILE *file, double y)
{
    static const struct {
        double x;
        const char *look, *name;
    } KEYS[] = {
        {66, "fill=\"#56b4e9\"", "a step at a node"},
        {300, "fill=\"" SVG_BLACK "\"", "tests a sphere"},
        {510, "fill=\"#ffffff\" stroke=\"#767676\"", "waits for others"},
        {746, "fill=\"#e0e0e0\"", "its ray is done"},
    };
    for (int i = 0; i < 4; i++) {
        svg_box(file, KEYS[i].x, y - 18, 36, 22, KEYS[i].look);
        svg_text(file, KEYS[i].x + 46, y, SVG_LEFT, "", "%s", KEYS[i].name);
    }
}

void draw_lanes(FILE *file, const Followed *followed)
{
    // A row of pixels that begins at the one that is followed.
    static Lane lanes[N_LANES];
    Steps *steps = world_allocate(sizeof *steps);
    for (int i = 0; i < N_LANES; i++) {
        require(record_pixel(followed->world, &WORLD_LAB.kernels[0], followed->x + i, followed->y,
                             steps));
        lanes[i] = lane_of(steps);
    }
    free(steps);
    Columns *columns = world_allocate(sizeof *columns);
    *columns = in_step(lanes);
    svg_begin(file, HEIGHT, "Divergence: 32 lanes over steps",
              "A row for each of 32 neighbouring rays, time to the right. At first all take the "
              "same steps at nodes. Then some are in leaves while others are at nodes, and each "
              "kind waits for the other; at the end a few rays go on while most are done.");
    svg_title(file, 24, 40, SVG_LEFT, "",
              "32 neighbouring rays in step: lanes work in %.0f%% of it",
              100.0 * columns->n_busy / (N_LANES * (double)columns->n));
    svg_text(file, LEFT - 12, 74, SVG_RIGHT, "", "lane");
    svg_text(file, RIGHT, 74, SVG_RIGHT, "", "%d steps", columns->n);
    for (int i = 0; i < N_LANES; i += 8) {
        svg_text(file, LEFT - 12, TOP + i * LANE + 14, SVG_RIGHT, "", "%d", i);
    }
    svg_text(file, LEFT - 12, BOTTOM - 2, SVG_RIGHT, "", "%d", N_LANES - 1);
    columns_draw(file, columns);
    legend_draw(file, BOTTOM + 38);
    svg_text(file, 24, BOTTOM + 86, SVG_LEFT, "",
             "The sphereflake, pixels %d to %d of row %d, lab 07's kernel;", followed->x,
             followed->x + N_LANES - 1, followed->y);
    svg_text(file, 24, BOTTOM + 114, SVG_LEFT, "",
             "in each turn of its loop first the nodes, then the leaves, sphere by sphere.");
    free(columns);
    svg_end(file);
}
