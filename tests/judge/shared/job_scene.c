// Scenes of a job: made from the seed, drawn by the oracle, written for the probe.
#include "job_scene.h"

#include "complain.h"
#include "job_sections.h"
#include "jobs.h"
#include "oracle2d.h"
#include "scene_vary.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

int job_scene_random(JobScene *scene, Random *random, int n_circles, int max_radius, int width,
                     int height)
{
    *scene = (JobScene){0};
    snprintf(scene->picture.title, sizeof scene->picture.title, "random scene, %d circles, %dx%d",
             n_circles, width, height);
    if (scene2d_random(n_circles, random_bits(random), 2, (float)max_radius, width, height,
                       &scene->scene) != 0) {
        return -1;
    }
    // Opaque circles would hide who forgets the fourth channel.
    for (int i = 0; i < n_circles; i++) {
        scene->scene.circles[i].a = (float)random_integer(random, 4, 16) / 16;
    }
    return 0;
}

int job_scene_named(JobScene *scene, Random *random, const char *name, int width, int height)
{
    *scene = (JobScene){0};
    const int columns = side_vary(random, width), rows = side_vary(random, height);
    if (scene2d_generate(name, columns, rows, &scene->scene) != 0) {
        return -1;
    }
    scene2d_vary(&scene->scene, random);
    snprintf(scene->picture.title, sizeof scene->picture.title, "a scene like \"%s\", %dx%d", name,
             scene->scene.width, scene->scene.height);
    return 0;
}

void job_scene_spread_depths(JobScene *scene)
{
    for (int i = 0; i < scene->scene.n_circles; i++) {
        scene->scene.circles[i].depth = 0x1p20f * scene->scene.circles[i].depth - 0x1p19f;
    }
}

// The places 0 and on in any order.
static void shuffle_places(Random *random, int n, int places[])
{
    for (int i = 0; i < n; i++) {
        const int j = (int)random_integer(random, 0, i);
        places[i] = places[j];
        places[j] = i;
    }
}

// Circles of one scene, at places where all have the same centre.
typedef struct DepthRow {
    int place;
    float depth;
    enum { DRAWN, CLEAR, BLACK, CLEAR_AND_BLACK } color;
} DepthRow;

static const DepthRow rows[] = {
    // None has a depth with which a minDepth may be thought to start. Nearer by one float,
    // farther by one, equal, nearer by less than any epsilon, much nearer.
    {0, 0.375f, DRAWN},
    {0, 0x1.7ffffep-2f, DRAWN},
    {1, 0.375f, DRAWN},
    {1, 0x1.800002p-2f, DRAWN},
    {3, 0.0f, DRAWN},
    {3, -0.0f, DRAWN},
    {4, 0.0f, DRAWN},
    {4, -0x1p-100f, DRAWN},
    {5, 1e30f, DRAWN},
    {5, -1e30f, DRAWN},
    // Alone: taken, however far or near.
    {2, FLT_MAX, DRAWN},
    {6, -3e38f, DRAWN},
    // Farther than a negative one, and than those that cannot be seen.
    {7, -1, DRAWN},
    {7, 0.5f, DRAWN},
    {8, 0.25f, CLEAR},
    {8, 0.75f, DRAWN},
    {9, 0.25f, BLACK},
    {9, 0.75f, DRAWN},
    {10, 0.25f, CLEAR_AND_BLACK},
    {10, 0.75f, DRAWN},
    // Covered by one that cannot be seen.
    {11, 0.75f, DRAWN},
    {11, 0.25f, CLEAR},
};

// Where circles have the same centre, one of them takes the pixels, and its depth says which:
// neither its colour nor its alpha does.
int job_scene_depths(JobScene *scene, Random *random)
{
    enum { N_ROWS = sizeof rows / sizeof *rows, N_PLACES = 12, PLACES_A_ROW = 4, PLACE = 8 };
    int places[N_PLACES] = {0};
    *scene = (JobScene){0};
    snprintf(scene->picture.title, sizeof scene->picture.title,
             "depths up to the largest float, and one float apart");
    if (scene2d_create(N_ROWS, PLACES_A_ROW * PLACE, N_PLACES / PLACES_A_ROW * PLACE,
                       &scene->scene) != 0) {
        return -1;
    }
    shuffle_places(random, N_PLACES, places);
    for (int i = 0; i < N_ROWS; i++) {
        const int place = places[rows[i].place];
        scene->scene.circles[i] = (Circle){.x = (float)(place % PLACES_A_ROW * PLACE + PLACE / 2),
                                           .y = (float)(place / PLACES_A_ROW * PLACE + PLACE / 2),
                                           .radius = (float)random_integer(random, 2, 4),
                                           .depth = rows[i].depth};
    }
    scene2d_turn(&scene->scene, random);
    scene2d_recolour(&scene->scene, random);
    for (int i = 0; i < N_ROWS; i++) {
        Circle *circle = &scene->scene.circles[i];
        if (rows[i].color == BLACK || rows[i].color == CLEAR_AND_BLACK) {
            circle->r = circle->g = circle->b = 0;
        }
        if (rows[i].color == CLEAR || rows[i].color == CLEAR_AND_BLACK) {
            circle->a = 0;
        }
    }
    return 0;
}

void job_scene_cover_second(JobScene *scene)
{
    Circle *circles = scene->scene.circles;
    float nearest = INFINITY;
    for (int i = 0; i < scene->scene.n_circles; i++) {
        nearest = fminf(nearest, circles[i].depth);
    }
    if (scene->scene.n_circles >= 2) {
        circles[0].x = circles[1].x;
        circles[0].y = circles[1].y;
        circles[0].depth = nearest / 2;
    }
}

int job_scene_pile(JobScene *scene, Random *random)
{
    // What 8 bits hold of it, and 16, is none of the numbers that a mistake may take for the most
    // there are. The picture is small, as each pixel asks all of them.
    const int n_circles = (1 << 16) + (1 << 8) + (int)random_integer(random, 11, 58);
    *scene = (JobScene){0};
    snprintf(scene->picture.title, sizeof scene->picture.title,
             "%d circles, one upon another, each nearer than those before it", n_circles);
    if (scene2d_create(n_circles, 8, 6, &scene->scene) != 0) {
        return -1;
    }
    for (int i = 0; i < n_circles; i++) {
        scene->scene.circles[i] =
            (Circle){.x = 4, .y = 3, .radius = 20, .depth = (float)(n_circles - i) / 16384};
    }
    scene2d_recolour(&scene->scene, random);
    return 0;
}

// The picture as if of a list no more were asked than some number that one may take for the most
// there are, or than 8 or 16 bits count. As DrawMistaken has it.
static Cause draw_fewer(const JobScene *scene, int are_squares, int mistake, Image *guess,
                        float *tolerances)
{
    static const u32 numbers[] = {64,   128,   256,   512,   1024,  2048,  4096, 8192,
                                  9999, 10000, 16384, 32767, 32768, 65535, 65536};
    static const u32 masks[] = {0xff, 0xffff};
    enum { N_MASKS = sizeof masks / sizeof *masks, N_NUMBERS = sizeof numbers / sizeof *numbers };
    const u32 n_circles = (u32)scene->scene.n_circles;
    const int is_cut = mistake < N_MASKS;
    if (mistake >= N_MASKS + N_NUMBERS || (!is_cut && numbers[mistake - N_MASKS] >= n_circles)) {
        return (Cause){0};
    }
    const OracleRules rules = {.squares = are_squares,
                               .most_asked = is_cut ? n_circles & masks[mistake]
                                                    : numbers[mistake - N_MASKS]};
    if (scene->tree.n_nodes > 0) {
        oracle2d_draw_leaves(scene->scene.circles, scene->scene.n_circles, &scene->tree, &rules,
                             guess, tolerances);
    } else {
        oracle2d_draw(scene->scene.circles, scene->scene.n_circles, &rules, guess, NULL);
    }
    return (Cause){.says = !is_cut        ? "drawn as if the end of a long list were never asked: "
                                            "there is no largest number of circles"
                           : mistake == 0 ? "drawn as if 8 bits held the number of circles"
                                          : "drawn as if 16 bits held the number of circles"};
}

#define NONE_YET                                                                                   \
    "drawn as if a colour of zeros said that there is no circle yet: a circle may be black, or "   \
    "transparent"
#define ENDS_AT_MISS                                                                               \
    "drawn as if the loop ended at the first circle that does not take the pixel: later ones may"
#define COVERS_ALL                                                                                 \
    "drawn as if every circle that is tested gave its colour, whether or not it takes the pixel"
#define UNCOVERING "drawn as if minDepth changed at circles that do not cover the pixel, too"
#define FIRST_LIST                                                                                 \
    "drawn as if every pixel read the list at the start of mapNode2Circles: a leaf's ids begin "   \
    "behind its circleMapOffset, and that of an inner node points to the start"
#define COUNT_AS_END                                                                               \
    "drawn as if a leaf's count were the position at which its list ends: it says how many ids "   \
    "there are"
#define PLACE_AS_ID "drawn as if a position in the list were used as the circle's id"
#define TOO_FAR "drawn as if far circles were never taken: minDepth starts too small"

// A picture of circles with a mistake, and what is said of it.
typedef struct DrawnMistake {
    Cause looks;
    OracleRules rules;
} DrawnMistake;

static const DrawnMistake mistakes[] = {
    // Before those of all depths, which a scene of few circles may not tell from these.
    {{.says = "drawn as if nothing could be nearer than depth 0: a depth may be negative"},
     {.ends_at_0 = 1}},
    {{.says = "drawn as if a negative minDepth said that there is no circle yet: a depth may "
              "be negative"},
     {.negative_is_none = 1}},
    {{"drawn as if the boundary did not belong to the circle (strict where it should not be)",
      MISTAKE_STRICT_BOUNDARY},
     {.strict_boundary = 1}},
    {{"drawn as if of two equal depths the later circle won", MISTAKE_LATER_OF_EQUALS},
     {.later_wins_ties = 1}},
    {{.says = "drawn as if only the first circle were asked"}, {.most_asked = 1}},
    {{.says = "drawn as if depth did not matter: the last circle covers the others"},
     {.ignore_depth = 1}},
    {{.says = "drawn as if depth did not matter: the first circle keeps the pixel"},
     {.first_wins = 1}},
    {{.says = "drawn as if the farthest circle won: the depth test is inverted"},
     {.farthest_wins = 1}},
    {{.says = "drawn as if the first circle were missing"}, {.skip_first = 1}},
    {{.says = "drawn as if the last circle were missing"}, {.skip_last = 1}},
    {{"shifted by half a pixel: the sample point is the integer coordinate", MISTAKE_SHIFTED_HALF},
     {.sample_offset = 0.5}},
    {{"shifted by half a pixel: the sample point is the integer coordinate", MISTAKE_SHIFTED_HALF},
     {.sample_offset = -0.5}},
    {{.says = "drawn with half the radius"}, {.diameter = 1}},
    {{.says = TOO_FAR}, {.too_far = -1e-300}},  // 0 and beyond
    {{.says = TOO_FAR}, {.too_far = 0.5}},
    {{.says = TOO_FAR}, {.too_far = 1}},
    {{.says = TOO_FAR}, {.too_far = 1e6}},
    {{.says = TOO_FAR}, {.too_far = 1e33}},
    {{.says = TOO_FAR}, {.too_far = FLT_MAX}},
    {{.says = "drawn as if minDepth started with the depth of the first circle, which is not "
              "nearer than itself"},
     {.first_is_limit = 1}},
    {{.says = "drawn as if circle 0 were none: 0 is an id as any other"}, {.first_is_nobody = 1}},
    {{.says = NONE_YET}, {.zero_is_none = CHANNEL_A}},
    {{.says = NONE_YET}, {.zero_is_none = CHANNEL_R}},
    {{.says = NONE_YET}, {.zero_is_none = CHANNEL_R | CHANNEL_G | CHANNEL_B}},
    {{.says = NONE_YET}, {.zero_is_none = CHANNEL_R | CHANNEL_G | CHANNEL_B | CHANNEL_A}},
    {{.says = "drawn as if transparent circles were none: the nearest circle takes the pixel, "
              "alpha included"},
     {.clear_is_hidden = 1}},
    {{.says = COVERS_ALL}, {.covers_all = 1, .ignore_depth = 1}},
    {{.says = ENDS_AT_MISS}, {.ends_at_miss = 1}},
    {{.says = UNCOVERING}, {.all_limit = 1}},
    {{.says = UNCOVERING}, {.last_limits = 1, .ignore_depth = 1}},
    {{.says = "drawn as if the last circles were missing"}, {.skip_last = 2}},
    {{.says = "drawn as if the last circles were missing"}, {.skip_last = 3}},
};

// Those of the lists of a tree.
static const DrawnMistake leaf_mistakes[] = {
    {{"drawn as if the first circle of every leaf were missing", MISTAKE_MISSING_IN_CELL},
     {.skip_first = 1}},
    {{"drawn as if the last circle of every leaf were missing", MISTAKE_MISSING_IN_CELL},
     {.skip_last = 1}},
    {{.says = COVERS_ALL}, {.covers_all = 1, .ignore_depth = 1}},
    {{.says = ENDS_AT_MISS}, {.ends_at_miss = 1}},
    {{.says = UNCOVERING}, {.all_limit = 1}},
    {{.says = UNCOVERING}, {.last_limits = 1, .ignore_depth = 1}},
    {{"drawn as if rows and columns were swapped where a leaf's circles are asked",
      MISTAKE_TRANSPOSED},
     {.transposed = 1}},
    {{.says = PLACE_AS_ID}, {.id = ID_PLACE_FROM_0}},
    {{.says = PLACE_AS_ID}, {.id = ID_PLACE_FROM_1}},
    {{.says = PLACE_AS_ID}, {.id = ID_PLACE_IN_MAP}},
    {{"drawn as if a leaf's count were used as a circle's id: the ids come behind it",
      MISTAKE_MISSING_IN_CELL},
     {.id = ID_BEFORE}},
    {{.says = COUNT_AS_END}, {.count_is_end = 1}},
    {{.says = COUNT_AS_END}, {.count_is_end = 2}},
    {{.says = FIRST_LIST}, {.first_ids = 1}},
    {{.says = FIRST_LIST}, {.first_list = 1}},
};

// The oracle's mistakes, of circles or of squares. As DrawMistaken has it.
static Cause draw_shapes(const void *pointer, int are_squares, int mistake, Image *guess,
                         float *tolerances)
{
    enum {
        N_MISTAKES = sizeof mistakes / sizeof *mistakes,
        N_LEAF_MISTAKES = sizeof leaf_mistakes / sizeof *leaf_mistakes
    };
    const JobScene *scene = pointer;
    const Circle *circles = scene->scene.circles;
    const int n_leaf_mistakes = scene->tree.n_nodes > 0 ? N_LEAF_MISTAKES : 0;
    // Tolerances stay 0: these pictures are as exact as the right one.
    if (mistake < N_MISTAKES) {
        OracleRules rules = mistakes[mistake].rules;
        rules.squares = are_squares;
        oracle2d_draw(circles, scene->scene.n_circles, &rules, guess, NULL);
        return mistakes[mistake].looks;
    }
    mistake -= N_MISTAKES;
    if (mistake < n_leaf_mistakes) {
        oracle2d_draw_leaves(circles, scene->scene.n_circles, &scene->tree,
                             &leaf_mistakes[mistake].rules, guess, tolerances);
        return leaf_mistakes[mistake].looks;
    }
    return draw_fewer(scene, are_squares, mistake - n_leaf_mistakes, guess, tolerances);
}

static Cause draw_mistaken(const void *scene, int mistake, Image *guess, float *tolerances)
{
    return draw_shapes(scene, 0, mistake, guess, tolerances);
}

Cause job_scene_draw_squares(const void *scene, int mistake, Image *guess, float *tolerances)
{
    return draw_shapes(scene, 1, mistake, guess, tolerances);
}

void job_scene_recognise(const JobScene *scene, ExpectedPicture *expected)
{
    expected_picture_recognise(expected, draw_mistaken, scene);
}

int job_scene_expect(JobScene *scene)
{
    const Scene2D *s = &scene->scene;
    ExpectedPicture *expected = &scene->picture.expected;
    const OracleRules right = {0};
    const size_t n_pixels = (size_t)s->width * (size_t)s->height;
    unsigned char *ambiguous = calloc(n_pixels, 1);
    expected->tolerances = calloc(n_pixels, sizeof *expected->tolerances);
    int result = image_create(s->width, s->height, &expected->reference);
    if (ambiguous == NULL || expected->tolerances == NULL) {
        complain("grade: no memory for a picture");
        result = -1;
    }
    if (result == 0) {
        oracle2d_draw(s->circles, s->n_circles, &right, &expected->reference, ambiguous);
        for (size_t i = 0; i < n_pixels; i++) {
            expected->tolerances[i] = ambiguous[i] ? INFINITY : 0;
        }
        job_scene_recognise(scene, expected);
    }
    free(ambiguous);
    return result;
}

int job_scene_write_circles(const JobScene *scene, int k, FILE *file)
{
    const Circle beyond = {.radius = 1e6f,
                           .depth = -1e9f,
                           .r = BEYOND_RED,
                           .g = BEYOND_GREEN,
                           .b = BEYOND_BLUE,
                           .a = 1};
    return job_array_write(file, k, "circles", scene->scene.circles, (size_t)scene->scene.n_circles,
                           &beyond, sizeof beyond);
}

int job_scene_write(const JobScene *scene, int k, FILE *file)
{
    const Scene2D *s = &scene->scene;
    const SceneJob job = {s->n_circles, s->width, s->height, scene->limits.maxDepth,
                          scene->limits.targetElementsPerNode};
    int result = job_section_write(file, k, NULL, &job, sizeof job);
    result |= job_title_write(file, k, scene->picture.title);
    result |= job_scene_write_circles(scene, k, file);
    const KdTree2D *tree = &scene->tree;
    if (tree->n_nodes > 0) {
        result |= job_section_write(file, k, "relations", tree->nodes_Relations,
                                    tree->n_nodes * sizeof *tree->nodes_Relations);
        result |= job_section_write(file, k, "flags", tree->nodes_flag,
                                    tree->n_nodes * sizeof *tree->nodes_flag);
        result |= job_section_write(file, k, "boxes", tree->nodes_BBox,
                                    tree->n_nodes * sizeof *tree->nodes_BBox);
        const u32 beyond = (u32)s->n_circles;
        result |= job_array_write(file, k, "map", tree->mapNode2Circles, tree->n_map, &beyond,
                                  sizeof beyond);
    }
    return result;
}

void job_scene_free(JobScene *scene)
{
    expected_picture_free(&scene->picture.expected);
    tree2d_free(&scene->tree);
    scene2d_free(&scene->scene);
}

static int write(const void *scene, int k, FILE *file)
{
    return job_scene_write(scene, k, file);
}

static void release(void *scene)
{
    job_scene_free(scene);
}

const SceneKind job_scene_kind = {write, release, offsetof(JobScene, picture)};
