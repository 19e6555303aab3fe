// Trees of lab 03's job that lab 02 does not build: leaf maps, which show in which leaf each pixel
// ends, one of them of stairs. See judge_03.h.
#include "judge_03.h"

#include "complain.h"
#include "message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int tree_create_03(u32 n_nodes, u32 n_map, KdTree2D *tree)
{
    *tree = (KdTree2D){.nodes_Relations = calloc(n_nodes, sizeof *tree->nodes_Relations),
                       .nodes_flag = calloc(n_nodes, sizeof *tree->nodes_flag),
                       .nodes_BBox = calloc(n_nodes, sizeof *tree->nodes_BBox),
                       .mapNode2Circles = calloc(n_map, sizeof *tree->mapNode2Circles),
                       .n_nodes = n_nodes,
                       .n_map = n_map};
    if (tree->nodes_Relations == NULL || tree->nodes_flag == NULL || tree->nodes_BBox == NULL ||
        tree->mapNode2Circles == NULL) {
        complain("grade: no memory for a tree");
        return -1;
    }
    return 0;
}

// ---- Leaf maps ----------------------------------------------------------------------------------

// Before and behind the nodes of a tree a leaf map has decoys, to which no way leads from the
// root: three pairs of leaves with the halves of the root's cell, and an inner node. A search for a
// leaf in the arrays ends in the first pair, or in the last, which are that node's children, so
// that who looks for the highest id finds them. The second pair are the children of every leaf: a
// search that does not ask nodes_flag ends there. All nodes between are as one more leaf.
enum {
    FIRST_PAIR = 1,
    FALSE_CHILDREN = 3,
    FALSE_PARENT = 5,
    NOWHERE = 6,
    N_BEFORE = 6,
    N_BEHIND = 2,
};

// Where a tree's node comes to lie.
static u32 moved(u32 id, u32 first_id)
{
    return id == 0 ? 0 : id + first_id;
}

static u32 last_pair(const KdTree2D *map)
{
    return map->n_nodes - N_BEHIND;
}

// The left or the right half of a cell.
static BBox2D half_of(BBox2D box, int is_right)
{
    *(is_right ? &box.minX : &box.maxX) = (box.minX + box.maxX) / 2;
    return box;
}

// Write the list of leaf `id` and two more circles that cover everything: one that is UNTAKEN,
// nearest of all, and the nearest but that, in the leaf's own colour.
static void colour_leaf(JobScene *scene, KdTree2D *map, u32 id, const u32 *list)
{
    const u32 untaken = (u32)scene->scene.n_circles, circle = untaken + 1;
    scene->scene.n_circles += 2;
    map->nodes_Relations[id].circleMapOffset = map->n_map;
    map->mapNode2Circles[map->n_map++] = list[0] + 2;
    memcpy(map->mapNode2Circles + map->n_map, list + 1, list[0] * sizeof *list);
    map->n_map += list[0];
    map->mapNode2Circles[map->n_map++] = untaken;
    map->mapNode2Circles[map->n_map++] = circle;
    scene->scene.circles[untaken] = (Circle){.radius = 100000, .depth = -2, .a = UNTAKEN};
    scene->scene.circles[circle] = (Circle){.radius = 100000,
                                            .depth = -1,
                                            .r = (float)(id % 16) / 16,
                                            .g = (float)(id / 16 % 16) / 16,
                                            .b = (float)(id / 256) / 512,
                                            .a = 1};
}

// Two leaves with the halves of the root's cell.
static void add_pair(JobScene *scene, KdTree2D *map, u32 first)
{
    for (u32 id = first; id < first + 2; id++) {
        map->nodes_flag[id] = LEAF;
        map->nodes_BBox[id] = half_of(map->nodes_BBox[0], id > first);
        colour_leaf(scene, map, id, &(u32){0});
    }
}

// The scene's tree as a leaf map; the decoys' lists come last. Nodes that are none of these have
// no cell.
static void fill_leaf_map(JobScene *scene, u32 first_id, KdTree2D *map)
{
    const KdTree2D *tree = &scene->tree;
    for (u32 id = 0; id < map->n_nodes; id++) {
        map->nodes_Relations[id].id = id;
        map->nodes_flag[id] = LEAF;
    }
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const NodeRel node = tree->nodes_Relations[id];
        const u32 to = moved(id, first_id);
        map->nodes_BBox[to] = tree->nodes_BBox[id];
        map->nodes_flag[to] = tree->nodes_flag[id];
        if (tree->nodes_flag[id] != LEAF) {
            map->nodes_Relations[to] =
                (NodeRel){to, moved(node.lChild, first_id), moved(node.rChild, first_id), 0};
            continue;
        }
        map->nodes_Relations[to] = (NodeRel){to, FALSE_CHILDREN, FALSE_CHILDREN + 1, 0};
        colour_leaf(scene, map, to, tree->mapNode2Circles + node.circleMapOffset);
    }
    add_pair(scene, map, FIRST_PAIR);
    add_pair(scene, map, FALSE_CHILDREN);
    add_pair(scene, map, last_pair(map));
    colour_leaf(scene, map, NOWHERE, &(u32){0});
    for (u32 id = NOWHERE + 1; id <= first_id; id++) {
        map->nodes_Relations[id].circleMapOffset = map->nodes_Relations[NOWHERE].circleMapOffset;
    }
    map->nodes_flag[FALSE_PARENT] = INNER;
    map->nodes_BBox[FALSE_PARENT] = tree->nodes_BBox[0];
    map->nodes_Relations[FALSE_PARENT] =
        (NodeRel){FALSE_PARENT, last_pair(map), last_pair(map) + 1, 0};
}

// Give each leaf a colour of its own: the picture then shows which leaf each pixel asked.
static int colour_leaves(JobScene *scene, u32 first_id)
{
    Scene2D *s = &scene->scene;
    const u32 n_leaves = scene->tree.n_nodes + N_BEFORE + N_BEHIND;
    KdTree2D map;
    Circle *circles = realloc(s->circles, ((size_t)s->n_circles + 2 * n_leaves) * sizeof *circles);
    if (circles == NULL) {
        complain("grade: no memory for a scene");
        return -1;
    }
    s->circles = circles;
    if (tree_create_03(first_id + scene->tree.n_nodes + N_BEHIND, scene->tree.n_map + 3 * n_leaves,
                       &map) != 0) {
        tree2d_free(&map);
        return -1;
    }
    map.n_map = 0;
    fill_leaf_map(scene, first_id, &map);
    tree2d_free(&scene->tree);
    scene->tree = map;
    return 0;
}

// The colour of a pixel that ends in this node: where that is no leaf, of the first list.
static void node_color(const JobScene *scene, u32 id, float *color)
{
    const KdTree2D *tree = &scene->tree;
    const u32 *list = tree->mapNode2Circles + tree->nodes_Relations[id].circleMapOffset;
    memcpy(color, &scene->scene.circles[list[list[0]]].r, IMAGE_CHANNELS * sizeof *color);
}

// A way to go wrong on the way down.
typedef struct Walk {
    Cause looks;
    u32 id_bits;      // of an id no more than these are kept; 0: all of it
    float narrowest;  // the way ends in cells that are narrower than this
    float lowest;     // or lower,
    float smallest;   // or narrower and lower than this
    int n_steps;      // after how many it ends; 0: in a leaf only
} Walk;

// The node in which it ends. A way that is lost may lead round in a ring.
static u32 end_of_walk(const KdTree2D *tree, int x, int y, const Walk *walk)
{
    u32 id = 0;
    for (int step = 0; step < MOST_LEVELS && tree->nodes_flag[id] != LEAF; step++) {
        const BBox2D cell = tree->nodes_BBox[id];
        const NodeRel node = tree->nodes_Relations[id];
        if ((walk->n_steps != 0 && step == walk->n_steps) ||
            cell.maxX - cell.minX < walk->narrowest || cell.maxY - cell.minY < walk->lowest ||
            fmaxf(cell.maxX - cell.minX, cell.maxY - cell.minY) < walk->smallest) {
            break;
        }
        id = cell_holds(tree->nodes_BBox[node.lChild], x, y) ? node.lChild : node.rChild;
        id = walk->id_bits != 0 ? id & walk->id_bits : id;
    }
    return id;
}

u32 leaf_at(const KdTree2D *tree, int x, int y)
{
    static const Walk right = {0};
    return cell_holds(tree->nodes_BBox[0], x, y) ? end_of_walk(tree, x, y, &right) : tree->n_nodes;
}

#define IN_ARRAYS                                                                                  \
    "drawn as if leaves were looked for in the arrays, and not on the way down from the root"
#define SMALL_CELLS "drawn as if the search ended in a small cell, leaf or not"
#define FEWER_BITS "drawn as if the id of a node were kept in too few bits"

// Number `mistake` of the known ways to go wrong; nothing behind the last.
typedef struct Mistaken {
    Walk walk;
    u32 pair;  // of leaves with the halves of the root's cell, in the place of a walk; 0: none
} Mistaken;

static Mistaken mistaken_walk(const KdTree2D *tree, int mistake)
{
    static const Walk walks[] = {
        {{.says = FEWER_BITS}, .id_bits = 0xff},
        {{.says = FEWER_BITS}, .id_bits = 0xffff},
        {{.says = SMALL_CELLS}, .narrowest = 1},
        {{.says = SMALL_CELLS}, .lowest = 1},
        {{.says = SMALL_CELLS}, .narrowest = 1, .lowest = 1},
        {{.says = SMALL_CELLS}, .smallest = 1},
    };
    const Mistaken pairs[] = {
        {.walk = {{.says = IN_ARRAYS}}, .pair = FIRST_PAIR},
        {.walk = {{.says = IN_ARRAYS}}, .pair = last_pair(tree)},
        {.walk = {{.says = "drawn as if lChild said what is a leaf: nodes_flag does, a leaf's "
                           "lChild means nothing"}},
         .pair = FALSE_CHILDREN},
    };
    const int n_steps = mistake - COUNT(pairs) - COUNT(walks);
    Mistaken mistaken = {.pair = 0};
    if (mistake < COUNT(pairs)) {
        mistaken = pairs[mistake];
    } else if (n_steps < 0) {
        mistaken.walk = walks[mistake - COUNT(pairs)];
    } else if (n_steps < MOST_LEVELS) {
        mistaken.walk.looks.says =
            "drawn as if the search ended after a fixed number of steps, leaf or not";
        mistaken.walk.n_steps = n_steps + 1;
    }
    return mistaken;
}

static u32 mistaken_end(const KdTree2D *tree, int x, int y, const Mistaken *mistaken)
{
    const u32 pair = mistaken->pair;
    return pair != 0 ? pair + !cell_holds(tree->nodes_BBox[pair], x, y)
                     : end_of_walk(tree, x, y, &mistaken->walk);
}

// As DrawMistaken of picture.h has it. Outside the root any leaf is right.
static Cause draw_mistaken(const void *pointer, int mistake, Image *guess, float *tolerances)
{
    const JobScene *scene = pointer;
    const KdTree2D *tree = &scene->tree;
    const Mistaken mistaken = mistaken_walk(tree, mistake);
    for (int i = 0; mistaken.walk.looks.says != NULL && i < guess->width * guess->height; i++) {
        const int x = i % guess->width, y = i / guess->width;
        node_color(scene, mistaken_end(tree, x, y, &mistaken),
                   guess->pixels + (size_t)i * IMAGE_CHANNELS);
        tolerances[i] = cell_holds(tree->nodes_BBox[0], x, y) ? 0 : INFINITY;
    }
    return mistaken.walk.looks;
}

Cause ends_look_03(const JobScene *scene, const u32 *ends)
{
    const int width = scene->scene.width, n_pixels = width * scene->scene.height;
    const KdTree2D *tree = &scene->tree;
    Mistaken mistaken = mistaken_walk(tree, 0);
    for (int mistake = 1; mistaken.walk.looks.says != NULL; mistake++) {
        int i = 0;
        while (i < n_pixels && (!cell_holds(tree->nodes_BBox[0], i % width, i / width) ||
                                ends[i] == mistaken_end(tree, i % width, i / width, &mistaken))) {
            i++;
        }
        if (i == n_pixels) {
            break;
        }
        mistaken = mistaken_walk(tree, mistake);
    }
    return mistaken.walk.looks;
}

int make_leaf_map(JobScene *scene, u32 first_id)
{
    if (colour_leaves(scene, first_id) != 0 || job_scene_expect(scene) != 0) {
        return -1;
    }
    const KdTree2D *tree = &scene->tree;
    ExpectedPicture *expected = &scene->picture.expected;
    Image *reference = &expected->reference;
    for (int i = 0; i < reference->width * reference->height; i++) {
        const u32 leaf = leaf_at(tree, i % reference->width, i / reference->width);
        expected->tolerances[i] = leaf == tree->n_nodes ? INFINITY : 0;
        if (leaf < tree->n_nodes) {
            node_color(scene, leaf, reference->pixels + (size_t)i * IMAGE_CHANNELS);
        }
    }
    expected_picture_recognise(expected, draw_mistaken, scene);
    return 0;
}

// The node of this colour; the number of nodes where it is none's.
static u32 node_of_color(const JobScene *scene, const float *color)
{
    const u32 n_nodes = scene->tree.n_nodes;
    const double id = 16 * (double)color[0] + 256 * (double)color[1] + 256 * 512 * (double)color[2];
    float own[IMAGE_CHANNELS];
    if (!(id >= 0 && id < n_nodes)) {
        return n_nodes;
    }
    node_color(scene, (u32)id, own);
    return memcmp(own, color, sizeof own) == 0 ? (u32)id : n_nodes;
}

char *first_wrong_end_03(const JobScene *scene, int k, const Sections *answers)
{
    const int width = scene->scene.width, n_pixels = width * scene->scene.height;
    const ProbeImage own = job_picture_answer(&scene->picture, k, answers);
    for (int i = 0; own.pixels != NULL && i < n_pixels; i++) {
        const int x = i % width, y = i / width;
        const u32 end = node_of_color(scene, probe_image_pixel(own, x, y));
        const u32 leaf = leaf_at(&scene->tree, x, y);
        if (leaf < scene->tree.n_nodes && end != leaf) {
            return end < scene->tree.n_nodes
                       ? message_new("at pixel (%d, %d) your search ends in node %u, expected %u",
                                     x, y, end, leaf)
                       : NULL;
        }
    }
    return NULL;
}

// ---- Stairs -------------------------------------------------------------------------------------

// Each second inner node cuts a strip off the rest: on the left, at the top, on the right, at the
// bottom, and so on; and each strip is halved, so that it is an inner node that is narrower than a
// pixel. Each fourth strip of a side holds pixels all the same, and few borders are whole. From the
// first strip crumbs are cut off, each of which is smaller than a pixel both ways, holds one, and
// is halved.
enum {
    STAIRS_SIDE = 64,
    N_STRIPS = MOST_LEVELS - 2,
    N_CRUMBS = 8,
    STAIRS_NODES = 1 + 4 * N_STRIPS + 4 * N_CRUMBS
};
#define CRUMB_HEIGHT 0.9f
#define STRIP_WIDTH 0.25f

// Cut a strip off: left and right start as the whole cell. Returns whether it is the right one.
static int cut_strip(u32 number, BBox2D *left, BBox2D *right)
{
    const int is_at_end = number % 4 >= 2;
    if (number % 2 == 0) {
        left->maxX = right->minX = is_at_end ? right->maxX - STRIP_WIDTH : left->minX + STRIP_WIDTH;
    } else {
        left->maxY = right->minY = is_at_end ? right->maxY - STRIP_WIDTH : left->minY + STRIP_WIDTH;
    }
    return is_at_end;
}

// Make a node an inner one, with the next two nodes as children, which get its cell. Returns the
// left one.
static u32 open_node(KdTree2D *tree, u32 id)
{
    const u32 lChild = tree->n_nodes;
    tree->n_nodes += 2;
    tree->nodes_flag[id] = INNER;
    tree->nodes_Relations[id] = (NodeRel){id, lChild, lChild + 1, 0};
    tree->nodes_BBox[lChild] = tree->nodes_BBox[lChild + 1] = tree->nodes_BBox[id];
    return lChild;
}

// Cut a node across a side, 'x' or 'y'. Returns the part with the lower coordinates.
static u32 cut_at(KdTree2D *tree, u32 id, char side, f32 at)
{
    const u32 lower = open_node(tree, id);
    BBox2D *boxes = tree->nodes_BBox;
    *(side == 'x' ? &boxes[lower].maxX : &boxes[lower].maxY) = at;
    *(side == 'x' ? &boxes[lower + 1].minX : &boxes[lower + 1].minY) = at;
    return lower;
}

static u32 halve(KdTree2D *tree, u32 id, char side)
{
    const BBox2D box = tree->nodes_BBox[id];
    return cut_at(tree, id, side,
                  side == 'x' ? (box.minX + box.maxX) / 2 : (box.minY + box.maxY) / 2);
}

// Cut crumbs off the beginning of a strip that is narrower than a pixel.
static void cut_crumbs(KdTree2D *tree, u32 strip)
{
    for (int i = 0; i < N_CRUMBS; i++) {
        const u32 crumb = cut_at(tree, strip, 'y', (f32)(i + 1) * CRUMB_HEIGHT);
        halve(tree, crumb, 'y');
        strip = crumb + 1;
    }
}

// All lists are empty: one of them is enough.
static int grow_stairs(KdTree2D *tree)
{
    if (tree_create_03(STAIRS_NODES, 1, tree) != 0) {
        return -1;
    }
    BBox2D *boxes = tree->nodes_BBox;
    u32 rest = 0;
    boxes[0] = (BBox2D){0, STAIRS_SIDE, 0, STAIRS_SIDE};
    tree->n_nodes = 1;
    for (u32 number = 0; number < N_STRIPS; number++) {
        const u32 left = open_node(tree, rest);
        const u32 strip = left + (u32)cut_strip(number, &boxes[left], &boxes[left + 1]);
        const u32 half = halve(tree, strip, number % 2 == 0 ? 'y' : 'x');
        if (number == 0) {
            cut_crumbs(tree, half);
        }
        rest = strip == left ? left + 1 : left;
    }
    return 0;
}

int draw_stairs(JobScene *scene)
{
    *scene = (JobScene){0};
    snprintf(scene->picture.title, sizeof scene->picture.title,
             "leaf map of a tree of %d levels whose cells end between pixels, %dx%d", MOST_LEVELS,
             STAIRS_SIDE, STAIRS_SIDE);
    scene->scene.width = scene->scene.height = STAIRS_SIDE;
    return grow_stairs(&scene->tree) == 0 ? make_leaf_map(scene, N_BEFORE) : -1;
}
