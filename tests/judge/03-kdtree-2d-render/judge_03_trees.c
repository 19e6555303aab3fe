// Trees of lab 03's job that lab 02 does not build: leaf maps, which show in which leaf each pixel
// ends, and cells whose borders lie just beside a whole pixel. See judge_03.h.
#include "judge_03.h"

#include "complain.h"

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

// In front of all nodes but the root a leaf map has four leaves to which no way leads from there,
// two pairs with the halves of the root's cell. A search for a leaf in the arrays ends in the first
// pair. The second are the children of every leaf, so a search that does not ask nodes_flag ends
// there.
enum { STRANGERS = 1, FALSE_CHILDREN = 3, N_STRANGERS = 4 };

static u32 moved(u32 id)
{
    return id == 0 ? 0 : id + N_STRANGERS;
}

// The left or the right half of a cell.
static BBox2D half_of(BBox2D box, int is_right)
{
    *(is_right ? &box.minX : &box.maxX) = (box.minX + box.maxX) / 2;
    return box;
}

// Write the list of leaf `id` and one more circle, nearest of all, that covers everything in the
// leaf's own colour.
static void colour_leaf(JobScene *scene, KdTree2D *map, u32 id, const u32 *list)
{
    const u32 circle = (u32)scene->scene.n_circles++;
    map->nodes_Relations[id].circleMapOffset = map->n_map;
    map->mapNode2Circles[map->n_map++] = list[0] + 1;
    memcpy(map->mapNode2Circles + map->n_map, list + 1, list[0] * sizeof *list);
    map->n_map += list[0];
    map->mapNode2Circles[map->n_map++] = circle;
    scene->scene.circles[circle] = (Circle){.radius = 100000,
                                            .depth = -1,
                                            .r = (float)(id % 7) / 6,
                                            .g = (float)(id / 7 % 7) / 6,
                                            .b = (float)(id / 49) / 64,
                                            .a = 1};
}

// The scene's tree as a leaf map; the strangers' lists come last.
static void fill_leaf_map(JobScene *scene, KdTree2D *map)
{
    const KdTree2D *tree = &scene->tree;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const NodeRel node = tree->nodes_Relations[id];
        const u32 to = moved(id);
        map->nodes_BBox[to] = tree->nodes_BBox[id];
        map->nodes_flag[to] = tree->nodes_flag[id];
        if (tree->nodes_flag[id] != LEAF) {
            map->nodes_Relations[to] = (NodeRel){to, moved(node.lChild), moved(node.rChild), 0};
            continue;
        }
        map->nodes_Relations[to] = (NodeRel){to, FALSE_CHILDREN, FALSE_CHILDREN + 1, 0};
        colour_leaf(scene, map, to, tree->mapNode2Circles + node.circleMapOffset);
    }
    for (u32 id = STRANGERS; id < STRANGERS + N_STRANGERS; id++) {
        map->nodes_Relations[id].id = id;
        map->nodes_BBox[id] = half_of(tree->nodes_BBox[0], id % 2 == 0);
        colour_leaf(scene, map, id, &(u32){0});
    }
}

// Give each leaf a colour of its own: the picture then shows which leaf each pixel asked.
static int colour_leaves(JobScene *scene)
{
    Scene2D *s = &scene->scene;
    const u32 n_nodes = scene->tree.n_nodes + N_STRANGERS;
    KdTree2D map;
    Circle *circles = realloc(s->circles, ((size_t)s->n_circles + n_nodes) * sizeof *circles);
    if (circles == NULL) {
        complain("grade: no memory for a scene");
        return -1;
    }
    s->circles = circles;
    if (tree_create_03(n_nodes, scene->tree.n_map + 2 * n_nodes, &map) != 0) {
        tree2d_free(&map);
        return -1;
    }
    map.n_map = 0;
    fill_leaf_map(scene, &map);
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

// The node to which so many steps lead, or the leaf before.
static u32 node_after(const KdTree2D *tree, int x, int y, int n_steps)
{
    u32 id = 0;
    for (int step = 0; step < n_steps && tree->nodes_flag[id] != LEAF; step++) {
        const NodeRel node = tree->nodes_Relations[id];
        id = cell_holds(tree->nodes_BBox[node.lChild], x, y) ? node.lChild : node.rChild;
    }
    return id;
}

// As DrawMistaken of picture.h has it. Outside the root any leaf is right.
static Cause draw_mistaken(const void *pointer, int mistake, Image *guess, float *tolerances)
{
    static const char *const looks[] = {
        "drawn as if leaves were looked for in the arrays, and not on the way down from the root",
        "drawn as if lChild told what is a leaf: nodes_flag does, a leaf's lChild means nothing",
        "drawn as if the search ended after a fixed number of steps, leaf or not"};
    enum { IN_ARRAYS, BY_CHILD, FIXED_STEPS };
    const JobScene *scene = pointer;
    const int n_steps = mistake - FIXED_STEPS;
    if (n_steps > MOST_LEVELS) {
        return (Cause){0};
    }
    for (int i = 0; i < guess->width * guess->height; i++) {
        const int x = i % guess->width, y = i / guess->width;
        const u32 pair = mistake == IN_ARRAYS ? STRANGERS : FALSE_CHILDREN;
        const u32 id = mistake >= FIXED_STEPS
                           ? node_after(&scene->tree, x, y, n_steps)
                           : pair + !cell_holds(scene->tree.nodes_BBox[pair], x, y);
        node_color(scene, id, guess->pixels + (size_t)i * IMAGE_CHANNELS);
        tolerances[i] = cell_holds(scene->tree.nodes_BBox[0], x, y) ? 0 : INFINITY;
    }
    return (Cause){.says = looks[mistake < FIXED_STEPS ? mistake : FIXED_STEPS]};
}

// Leaves are looked for from the last on: strangers come first, and hold no more than the root.
u32 leaf_at(const KdTree2D *tree, int x, int y)
{
    u32 id = tree->n_nodes;
    while (id-- > 0) {
        if (tree->nodes_flag[id] == LEAF && cell_holds(tree->nodes_BBox[id], x, y)) {
            return id;
        }
    }
    return tree->n_nodes;
}

int make_leaf_map(JobScene *scene)
{
    if (colour_leaves(scene) != 0 || job_scene_expect(scene) != 0) {
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
    expected->draw_mistaken = draw_mistaken;
    return 0;
}

// ---- Stairs -------------------------------------------------------------------------------------

// Each inner node cuts a strip off the rest: on the left, at the top, on the right, at the bottom,
// and so on. A strip is wider than a pixel, so each holds some, and its border is seldom whole.
enum { STAIRS_SIDE = 48, N_STRIPS = MOST_LEVELS - 1 };
#define STRIP_WIDTH 1.25f

// Cut a strip off: left and right start as the whole cell.
static void cut_strip(u32 number, BBox2D *left, BBox2D *right)
{
    const int is_at_end = number % 4 >= 2;
    if (number % 2 == 0) {
        left->maxX = right->minX = is_at_end ? right->maxX - STRIP_WIDTH : left->minX + STRIP_WIDTH;
    } else {
        left->maxY = right->minY = is_at_end ? right->maxY - STRIP_WIDTH : left->minY + STRIP_WIDTH;
    }
}

// All lists are empty.
static int grow_stairs(KdTree2D *tree)
{
    if (tree_create_03(2 * N_STRIPS + 1, N_STRIPS + 1, tree) != 0) {
        return -1;
    }
    u32 rest = 0;
    tree->nodes_BBox[0] = (BBox2D){0, STAIRS_SIDE, 0, STAIRS_SIDE};
    for (u32 number = 0; number < N_STRIPS; number++) {
        const u32 left = 2 * number + 1, right = left + 1;
        tree->nodes_BBox[left] = tree->nodes_BBox[right] = tree->nodes_BBox[rest];
        cut_strip(number, &tree->nodes_BBox[left], &tree->nodes_BBox[right]);
        tree->nodes_flag[rest] = INNER;
        tree->nodes_Relations[rest] = (NodeRel){rest, left, right, 0};
        rest = number % 4 >= 2 ? left : right;
        tree->nodes_Relations[rest == left ? right : left].circleMapOffset = number;
    }
    tree->nodes_Relations[rest].circleMapOffset = N_STRIPS;
    return 0;
}

int draw_stairs(JobScene *scene)
{
    *scene = (JobScene){0};
    snprintf(scene->picture.title, sizeof scene->picture.title,
             "leaf map of a tree of %d levels whose cells end between pixels, %dx%d", MOST_LEVELS,
             STAIRS_SIDE, STAIRS_SIDE);
    scene->scene.width = scene->scene.height = STAIRS_SIDE;
    return grow_stairs(&scene->tree) == 0 ? make_leaf_map(scene) : -1;
}

// ---- Borders beside a pixel ---------------------------------------------------------------------

// How far a border lies behind the pixel's coordinate, which is 100: 2^-17 parts floats there.
static const float beside[N_BESIDE] = {0.25f,     0.5f,     0.75f,    0x1p-10f,
                                       -0x1p-10f, 0x1p-17f, -0x1p-17f};

int add_borders_beside(const KdTree2D *tree, KdTree2D *more, ChildJob jobs[N_BESIDE_JOBS])
{
    const u32 n_given = tree->n_nodes;
    if (tree_create_03(n_given + 3 * 2 * N_BESIDE, 1, more) != 0) {
        return -1;
    }
    memcpy(more->nodes_Relations, tree->nodes_Relations, n_given * sizeof(NodeRel));
    memcpy(more->nodes_BBox, tree->nodes_BBox, n_given * sizeof(BBox2D));
    for (u32 i = 0; i < 2 * N_BESIDE; i++) {
        const u32 id = n_given + 3 * i;
        const float border = 100 + beside[i / 2];
        BBox2D *boxes = more->nodes_BBox + id;
        more->nodes_Relations[id] = (NodeRel){id, id + 1, id + 2, 0};
        boxes[0] = boxes[1] = boxes[2] = (BBox2D){90, 110, 90, 110};
        *(i % 2 == 0 ? &boxes[1].maxX : &boxes[1].maxY) = border;
        *(i % 2 == 0 ? &boxes[2].minX : &boxes[2].minY) = border;
        for (i32 step = -1; step <= 1; step++) {
            *jobs++ = i % 2 == 0 ? (ChildJob){100 + step, 95, id} : (ChildJob){95, 100 + step, id};
        }
    }
    return 0;
}
