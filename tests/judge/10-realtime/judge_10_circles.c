// Lab 10's tiles of circles: scenes and their trees, the pixels of each tile, and how many circles
// it asks. What a pixel shows comes from brute force over the whole scene.
#include "judge_10.h"

#include "complain.h"
#include "message.h"
#include "oracle2d.h"
#include "random3d.h"
#include "scene2d.h"
#include "words.h"

#include <string.h>

// As often as render_circles.cl looks whether a tile is done.
#define CIRCLES_A_LOOK 8

// ---- Scenes -------------------------------------------------------------------------------------

// The first of the far tiles. 10, 12 or 16 bits of their pixels are less than any of their planes.
enum { FAR_TILE = 70000 / CIRCLE_TILE_SIDE };

static const struct {
    int columns, rows;  // tiles
    int n_circles;
    float min_radius, max_radius;
    int is_deep;     // each plane cuts off one tile
    u32 first_id;    // of all nodes but the root: what lies before it belongs to no tree
    int first_tile;  // on both axes
    int is_off_grid;
} plans[N_CIRCLE_SCENES] = {
    {1, 1, 6, 2, 12, 0, 1, 0, 0},          // the root is a leaf
    {5, 4, 60, 2, 12, 0, 1, 0, 0},         // background is seen
    {5, 4, 120, 10, 60, 0, 1, 0, 0},       // most is hidden
    {8, 8, 40, 1, 8, 0, 1, 0, 0},          // a leaf for nearly every tile
    {20, 1, 40, 1, 8, 1, 1, 0, 0},         // as deep as a tree of 20 tiles can be
    {5, 4, 40, 2, 12, 0, FAR_NODE, 0, 0},  // ids as in a picture of a million tiles
    // Nothing but planes: 60 levels of them, and all beyond the pixels that 16 bits can number.
    {61, 1, 0, 0, 0, 1, 1, FAR_TILE, 0},
    {1, 20, 0, 0, 0, 1, 1, FAR_TILE, 0},
    {5, 4, 60, 2, 12, 0, 1, 0, 1},
};

typedef struct TileRange {
    int min[2], max[2];  // tiles, [min, max) on x and y
} TileRange;

// A tree that grows in the job's arrays: nodes still to be closed have their tiles in `ranges`.
typedef struct Growing {
    const CircleScene10 *scene;
    TileNode *nodes;
    TileRange ranges[2 * N_CIRCLE_TILES];  // see range_of()
    u32 first_id;                          // of all nodes but the root
    u32 n_nodes;                           // up to the last one
    TileCircle *circles;
    u32 n_circles;
} Growing;

static TileRange *range_of(Growing *tree, u32 id)
{
    return &tree->ranges[id == 0 ? 0 : id - tree->first_id + 1];
}

// Is circle `a` of a scene before circle `b`?
static int is_nearer(const CircleScene10 *scene, int a, int b)
{
    const float depth_a = scene->circles[a].depth, depth_b = scene->circles[b].depth;
    return depth_a < depth_b || (depth_a == depth_b && a < b);
}

// A leaf's circles, by inserting each where it belongs. A pixel is a point, so the last ones lie on
// the box's border. What is hidden is in the list, too.
static void close_as_leaf(Growing *tree, u32 id)
{
    const TileRange tiles = *range_of(tree, id);
    const float side = CIRCLE_TILE_SIDE;
    const BBox2D box = {(float)tiles.min[0] * side, (float)tiles.max[0] * side - 1,
                        (float)tiles.min[1] * side, (float)tiles.max[1] * side - 1};
    int ids[MOST_CIRCLES];
    u32 n_ids = 0;
    for (int i = 0; i < tree->scene->n_circles; i++) {
        if (!oracle2d_overlaps_box(tree->scene->circles[i], box)) {
            continue;
        }
        u32 place = n_ids++;
        for (; place > 0 && is_nearer(tree->scene, i, ids[place - 1]); place--) {
            ids[place] = ids[place - 1];
        }
        ids[place] = i;
    }
    tree->nodes[id] =
        (TileNode){.split_axis = KD_LEAF, .first = tree->n_circles, .n_circles = n_ids};
    for (u32 i = 0; i < n_ids; i++) {
        const Circle circle = tree->scene->circles[ids[i]];
        tree->circles[tree->n_circles++] = (TileCircle){
            circle.x, circle.y, circle.radius * circle.radius, tree->scene->colors[ids[i]]};
    }
}

// Planes stand at any border of tiles, and not only in the middle.
static void close_as_inner(Growing *tree, Random *random, u32 id, u32 axis, int is_deep)
{
    const TileRange tiles = *range_of(tree, id);
    const int first_border = tiles.min[axis] + 1, last_border = tiles.max[axis] - 1;
    const int split =
        is_deep ? first_border : (int)random_integer(random, first_border, last_border);
    const u32 first = tree->n_nodes;
    tree->n_nodes += 2;
    *range_of(tree, first) = *range_of(tree, first + 1) = tiles;
    range_of(tree, first)->max[axis] = range_of(tree, first + 1)->min[axis] = split;
    tree->nodes[id] = (TileNode){split * CIRCLE_TILE_SIDE, axis, first, 0};
}

static void grow(Growing *tree, Random *random, TileRange all, int is_deep)
{
    *range_of(tree, 0) = all;
    tree->n_nodes = tree->first_id;
    for (u32 id = 0; id < tree->n_nodes; id = id == 0 ? tree->first_id : id + 1) {
        const TileRange tiles = *range_of(tree, id);
        const int width = tiles.max[0] - tiles.min[0], height = tiles.max[1] - tiles.min[1];
        const int is_below = id > tree->first_id + 1;  // the root's children
        // Some leaves hold many tiles.
        if ((width == 1 && height == 1) || (is_below && !is_deep && one_in(random, 6))) {
            close_as_leaf(tree, id);
        } else {
            close_as_inner(tree, random, id,
                           height == 1 || (width > 1 && one_in(random, 2)) ? 0 : 1, is_deep);
        }
    }
}

// A random scene in which depths are equal now and then, and colours are all different; the first
// circle is black and transparent.
static int roll_scene(Random *random, int k, CircleScene10 *scene)
{
    Scene2D drawn;
    scene->n_circles = 0;
    if (plans[k].n_circles == 0) {
        return 0;
    }
    if (scene2d_random(plans[k].n_circles, random_bits(random), plans[k].min_radius,
                       plans[k].max_radius, plans[k].columns * CIRCLE_TILE_SIDE,
                       plans[k].rows * CIRCLE_TILE_SIDE, &drawn) != 0) {
        return -1;
    }
    scene->n_circles = drawn.n_circles;
    for (int i = 0; i < drawn.n_circles; i++) {
        Circle *circle = &scene->circles[i];
        *circle = drawn.circles[i];
        circle->depth = floorf(circle->depth * 16) / 16;
        if (plans[k].is_off_grid) {
            circle->x += random_off_grid(random);
            circle->y += random_off_grid(random);
            circle->radius += random_off_grid(random);
        }
        // An odd factor: different numbers stay different.
        scene->colors[i] = (u32)i * 0x9e3779b1u;
    }
    scene2d_free(&drawn);
    return 0;
}

int roll_circles_10(Random *random, Job10 *job)
{
    u32 n_nodes = 0, n_circles = 0;
    int n_tiles = 0;
    // Who comes to a node of no tree is at an end there.
    for (int i = 0; i < MOST_CIRCLE_NODES; i++) {
        job->circle_nodes[i] = (TileNode){.split_axis = KD_LEAF};
    }
    for (int k = 0; k < N_CIRCLE_SCENES; k++) {
        if (roll_scene(random, k, &job->circle_scenes[k]) != 0) {
            return -1;
        }
        Growing tree = {.scene = &job->circle_scenes[k],
                        .first_id = plans[k].first_id,
                        .nodes = job->circle_nodes + n_nodes,
                        .circles = job->leaf_circles + n_circles};
        const int from = plans[k].first_tile;
        const TileRange all = {{from, from}, {from + plans[k].columns, from + plans[k].rows}};
        grow(&tree, random, all, plans[k].is_deep);
        for (int i = 0; i < plans[k].columns * plans[k].rows; i++) {
            job->scene_of_tile[n_tiles] = k;
            job->circle_tiles[n_tiles++] = (CircleTileJob){
                n_nodes, n_circles, (from + i % plans[k].columns) * CIRCLE_TILE_SIDE,
                (from + i / plans[k].columns) * CIRCLE_TILE_SIDE};
        }
        n_nodes += tree.n_nodes;
        n_circles += tree.n_circles;
    }
    return 0;
}

// ---- Pixels and work ----------------------------------------------------------------------------

// The colour of a pixel: of the nearest circle of the whole scene that covers it.
static u32 expected_color(const CircleScene10 *scene, int x, int y)
{
    int nearest = -1;
    for (int i = 0; i < scene->n_circles; i++) {
        if (oracle2d_covers(scene->circles[i], x, y) &&
            (nearest < 0 || is_nearer(scene, i, nearest))) {
            nearest = i;
        }
    }
    return nearest < 0 ? 0 : scene->colors[nearest];
}

// May float decide otherwise at a pixel for one of the scene's circles? Only off the grid.
static int is_ambiguous(const CircleScene10 *scene, int x, int y)
{
    int i = 0;
    while (i < scene->n_circles && !oracle2d_is_ambiguous(scene->circles[i], x, y)) {
        i++;
    }
    return i < scene->n_circles;
}

#define GIVEN                                                                                      \
    const Job10 *in = job;                                                                         \
    const CircleTileAnswer *found = (const CircleTileAnswer *)answers + i

static const CircleScene10 *scene_of(const Job10 *job, int i)
{
    return &job->circle_scenes[job->scene_of_tile[i]];
}

// A pixel of tile i, in the picture.
static int x_of(const Job10 *job, int i, int pixel)
{
    return job->circle_tiles[i].x + pixel % ROW_PIXELS;
}

static int y_of(const Job10 *job, int i, int pixel)
{
    return job->circle_tiles[i].y + pixel / ROW_PIXELS;
}

static u32 color_of(const Job10 *job, int i, int pixel)
{
    return expected_color(scene_of(job, i), x_of(job, i, pixel), y_of(job, i, pixel));
}

static int is_ambiguous_at(const Job10 *job, int i, int pixel)
{
    return is_ambiguous(scene_of(job, i), x_of(job, i, pixel), y_of(job, i, pixel));
}

// The first wrong pixel of a tile, or CIRCLE_TILE_PIXELS.
static int wrong_pixel(const Job10 *in, int i, const CircleTileAnswer *found)
{
    int k = 0;
    while (k < CIRCLE_TILE_PIXELS &&
           (found->colors[k] == color_of(in, i, k) || is_ambiguous_at(in, i, k))) {
        k++;
    }
    return k;
}

RIGHT(are_pixels, wrong_pixel(in, i, found) == CIRCLE_TILE_PIXELS)

static char *describe_pixel(const void *job, int i, const void *answers)
{
    GIVEN;
    const int k = wrong_pixel(in, i, found);
    return message_new("a scene of %d circles, pixel (%d, %d), in the tile from (%d, %d) on: found "
                       "%s, expected %s",
                       scene_of(in, i)->n_circles, x_of(in, i, k), y_of(in, i, k), x_of(in, i, 0),
                       y_of(in, i, 0), words_rgba(found->colors[k]).text,
                       words_rgba(color_of(in, i, k)).text);
}

const Function circle_pixels_10 = {"circle_tiles",
                                   N_CIRCLE_TILES,
                                   sizeof(CircleTileAnswer),
                                   .is_right = are_pixels,
                                   .describe = describe_pixel,
                                   .counted = "tiles"};

// After how many circles of its list is a tile done? All of them where it never is.
static u32 count_needed(const Job10 *job, int i)
{
    const CircleTileJob tile = job->circle_tiles[i];
    const TileNode leaf = job->circle_nodes[tile.first_node + leaf_10_of_tile(job, i)];
    const TileCircle *circles = job->leaf_circles + tile.first_circle + leaf.first;
    u32 most = 0;
    for (int pixel = 0; pixel < CIRCLE_TILE_PIXELS; pixel++) {
        const double x = tile.x + pixel % ROW_PIXELS, y = tile.y + pixel / ROW_PIXELS;
        u32 n = 0;
        for (int is_covered = 0; n < leaf.n_circles && !is_covered; n++) {
            const double dx = x - (double)circles[n].x, dy = y - (double)circles[n].y;
            is_covered = dx * dx + dy * dy <= (double)circles[n].radius_squared;
        }
        most = n > most ? n : most;
    }
    const u32 until_look = (most + CIRCLES_A_LOOK - 1) / CIRCLES_A_LOOK * CIRCLES_A_LOOK;
    return until_look < leaf.n_circles ? until_look : leaf.n_circles;
}

static int is_ambiguous_tile(const Job10 *in, int i)
{
    int k = 0;
    while (k < CIRCLE_TILE_PIXELS && !is_ambiguous_at(in, i, k)) {
        k++;
    }
    return k < CIRCLE_TILE_PIXELS;
}

// The loop is given, so the number is known: it says whether what is painted is closed, at once.
RIGHT(is_work, found->n_tests == count_needed(in, i) || is_ambiguous_tile(in, i))

KNOWN_LIST(known)
{
    GIVEN;

    ONLY(goes_on, found->n_tests > count_needed(in, i),
         "the tile is done, and it goes on: what is covered is not closed");
    ONLY(given_up, found->n_tests < count_needed(in, i),
         "the tile is given up before it is done: what is not covered is closed");
    return NO_MORE;
}

static char *describe_work(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("a scene of %d circles, the tile from (%d, %d) on: found %u circles asked, "
                       "expected %u",
                       scene_of(in, i)->n_circles, x_of(in, i, 0), y_of(in, i, 0), found->n_tests,
                       count_needed(in, i));
}

const Function circle_work_10 = {"circle_tiles", N_CIRCLE_TILES, sizeof(CircleTileAnswer),
                                 KNOWING(is_work, describe_work, known), .counted = "tiles"};
