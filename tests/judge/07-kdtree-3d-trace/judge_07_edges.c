// The inputs of lab 07's functions that stand in every job, whatever the seed: what lies a hair
// beside a border, is as good as along a plane, or is as near or as far as a hit may be. They are
// the last ones of each range, behind those that are rolled (judge_07_inputs.c).
//
// No right solution rounds in them, or not by as much as counts: planes at 0, and else numbers of
// few bits. So who adds a small number to a comparison is wrong here, however small it is.
#include "judge_07.h"

#include <math.h>
#include <string.h>

// Directions that are not 0, from what may come out of a camera to what is just above nothing; and
// what is less than a thousandth of any epsilon that one would choose.
#define SMALL 0x1p-17f
#define SMALLER 0x1p-24f
#define SMALLEST 0x1p-100f

// ---- clip_to_box --------------------------------------------------------------------------------

// The box is that from 0 to 1 on each axis.
static const struct {
    enum ClipRange range;
    Vec3 origin, direction;
    float t_min, t_max;
} clip_edges[] = {
    // The part ends just before the box, or begins just behind it.
    {CLIP_BESIDE, {-2, 0.5f, 0.5f}, {1, 0, 0}, 0, 0x1.fffffep+0f},
    {CLIP_BESIDE, {0.5f, 3, 0.5f}, {0, -1, 0}, 0, 0x1.ffffp+0f},
    {CLIP_BESIDE, {0.5f, 0.5f, -2}, {0, 0, 1}, 0x1.800002p+1f, 8},
    {CLIP_BESIDE, {3, 0.5f, 0.5f}, {-1, 0, 0}, 0x1.8001p+1f, 8},
    // The box is just behind the eye.
    {CLIP_BESIDE, {0x1.00001p+0f, 0.5f, 0.5f}, {1, 0, 0}, 0, INFINITY},
    {CLIP_BESIDE, {0.5f, -0x1p-17f, 0.5f}, {0, -1, 0}, 0, INFINITY},
    // It is passed at an edge, by some 1e-5.
    {CLIP_BESIDE, {-0.6f, 0.20001f, 0.5f}, {0.6f, 0.8f, 0}, 0, INFINITY},
    {CLIP_BESIDE, {1.8f, 0.5f, 0.40001f}, {-0.8f, 0, 0.6f}, 0, INFINITY},
    // What is inside is not empty, though short.
    {CLIP_ALONG, {-1, 0.5f, 0.5f}, {1, 0, 0}, 0, 0x1.000002p+0f},
    {CLIP_ALONG, {0.5f, 0.5f, 3}, {0, 0, -1}, 0x1.7ffffep+1f, 8},
    // Along the planes and just beside the box.
    {CLIP_ALONG, {-1, 0x1.000002p+0f, 0.5f}, {1, 0, 0}, 0, INFINITY},
    {CLIP_ALONG, {0.5f, 3, -0x1p-17f}, {-0.0f, -1, 0}, 0, INFINITY},
    // Not quite along them: in and out through these planes all the same, at t = 0.5.
    {CLIP_ALONG, {-SMALL / 2, 0.5f, 0.5f}, {SMALL, 0.6f, 0.8f}, 0, INFINITY},
    {CLIP_ALONG, {0.5f, SMALLER / 2, 0.5f}, {0.6f, -SMALLER, 0.8f}, 0, INFINITY},
    {CLIP_ALONG, {0.5f, 0.5f, -SMALLEST / 2}, {0.8f, 0.6f, SMALLEST}, 0, INFINITY},
};

static void set_clips(Inputs07 *inputs)
{
    static const BBox3D box = {{0, 0, 0}, {1, 1, 1}};
    int n_set[N_CLIP_RANGES] = {0};
    for (int i = 0; i < COUNT(clip_edges); i++) {
        const enum ClipRange range = clip_edges[i].range;
        inputs->clips[(range + 1) * N_CLIP_INPUTS - ++n_set[range]] =
            (ClipJob){box, clip_edges[i].origin, clip_edges[i].direction, clip_edges[i].t_min,
                      clip_edges[i].t_max};
    }
}

// ---- near_side ----------------------------------------------------------------------------------

// With the eye on the plane any inverse counts that is not 0.
static void set_sides(Inputs07 *inputs)
{
    static const float inverses[] = {SMALL,     -SMALL,       SMALLER,       -SMALLER,  SMALLEST,
                                     -SMALLEST, 1 / SMALLEST, -1 / SMALLEST, 1 / SMALL, -1 / SMALL};
    for (int i = 0; i < COUNT(inverses); i++) {
        const u32 axis = (u32)i % 3, first = 7;
        inputs->sides[2 * N_SIDE_INPUTS - 1 - i] =
            (SideJob){{0.5f, axis, first, 0}, 0.5f, inverses[i]};
    }
}

// ---- children_on_ray ----------------------------------------------------------------------------

// The eye and 1 / direction are so that t_split, which follows from them, is not rounded.
static const struct {
    enum PlaneRange range;
    float t_split, origin, inverse, t_min, t_max;
} plane_edges[] = {
    // Just beyond the part and just before its end; a little more.
    {PLANES_AHEAD, 0x1.000002p+2f, 0, 1, 2, 4},
    {PLANES_AHEAD, 0x1.fffffep+1f, 0, -4, 2, 4},
    {PLANES_AHEAD, 0x1.00008p+2f, 0, -1, 2, 4},
    {PLANES_AHEAD, 0x1.ffff8p+1f, 0, 4, 2, 4},
    {PLANES_AHEAD, 0x1.f40002p+9f, 0, 1, 2, 1000},
    // Just before the part and just behind its begin.
    {PLANES_AHEAD, 0x1.fffffep+0f, 0, 1, 2, 4},
    {PLANES_AHEAD, 0x1.000002p+1f, 0, -4, 2, 4},
    {PLANES_AHEAD, 0x1.ffff8p+0f, 0, -1, 2, 4},
    {PLANES_AHEAD, 0x1.00008p+1f, 0, 4, 2, 4},
    {PLANES_AHEAD, 0x1.f3fffep+9f, 0, 1, 1000, 1001},
    // Far from the scene's origin. The difference is exact, and so is t_split; of products that are
    // subtracted more is lost than the part's ends lie apart, also where the compiler fuses one.
    {PLANES_AHEAD, 75, 81917.625f, -1200, 0, 76},
    {PLANES_AHEAD, 468.75f, 104182.5625f, 1500, 470, 1000},
    {PLANES_AHEAD, 325, -82009.3125f, 1300, 324, 1000},
    {PLANES_AHEAD, 893.75f, 76867.3125f, -1100, 0, 892.5f},
    // Just ahead of the eye, in the part or before it; just behind the eye.
    {PLANES_BEHIND, 0x1p-20f, 0, 1, 0, 4},
    {PLANES_BEHIND, SMALLER, 0, -4, 0, 4},
    {PLANES_BEHIND, SMALLEST, 0, 1, 0, 4},
    {PLANES_BEHIND, 0x1p-20f, 0, -1, 1, 4},
    {PLANES_BEHIND, SMALLEST, 0, 4, 1, 4},
    {PLANES_BEHIND, -0x1p-20f, 0, 1, 0, 4},
    {PLANES_BEHIND, -SMALLER, 0, -4, 0, 4},
    {PLANES_BEHIND, -SMALLEST, 0, 1, 1, 4},
    // Not quite along the plane, at 0: it is met.
    {PLANES_ALONG, 2, -2 * SMALL, 1 / SMALL, 1, 4},
    {PLANES_ALONG, 2, 2 * SMALLER, -1 / SMALLER, 1, 4},
    {PLANES_ALONG, 2, -2 * SMALLEST, 1 / SMALLEST, 1, 4},
    {PLANES_ALONG, 0.5f, 0.5f * SMALL, -1 / SMALL, 1, 4},
};

static void set_planes(Inputs07 *inputs)
{
    int n_set[N_PLANE_RANGES] = {0};
    for (int i = 0; i < COUNT(plane_edges); i++) {
        const enum PlaneRange range = plane_edges[i].range;
        const float origin = plane_edges[i].origin, inverse = plane_edges[i].inverse;
        const float split_pos = origin + plane_edges[i].t_split / inverse;
        const u32 axis = (u32)i % 3, first = 7;
        inputs->planes[(range + 1) * N_PLANE_INPUTS - ++n_set[range]] =
            (PlaneJob){{split_pos, axis, first, 0},
                       origin,
                       inverse,
                       plane_edges[i].t_min,
                       plane_edges[i].t_max};
    }
}

// ---- search_leaf --------------------------------------------------------------------------------

// The eye is at 0, and looks along an axis at the middle of one sphere or two at one place. How far
// apart two hits are in float there: a hair.
#define HAIR_AT_63 0x1p-18f

typedef enum SoFar { NO_HIT, OF_ANOTHER_LEAF, OF_THE_LEAFS_FIRST } SoFar;

static const struct {
    float distance, radii[2];  // 0 for no second sphere
    SoFar so_far;
    float t_so_far;
} leaf_edges[] = {
    // Two hits a hair apart: the nearer one last, or first.
    {64, {0.25f, 0.25f + HAIR_AT_63}, NO_HIT, INFINITY},
    {64, {0.25f + HAIR_AT_63, 0.25f}, NO_HIT, INFINITY},
    {8, {0x1p-4f, 0x1p-4f + 0x1p-21f}, NO_HIT, INFINITY},
    {1024, {0.25f, 0.25f + 0x1p-14f}, NO_HIT, INFINITY},
    // Of which one is the hit so far, of a sphere with a higher id.
    {64, {0.25f, 0}, OF_ANOTHER_LEAF, 63.75f + HAIR_AT_63},
    {64, {0.25f, 0}, OF_ANOTHER_LEAF, 63.75f - HAIR_AT_63},
    // Just before the eye, and farther than anybody expects.
    {0.25f + 0x1p-11f, {0.25f, 0}, NO_HIT, INFINITY},
    {0x1p-6f + 0x1p-17f, {0x1p-6f, 0}, NO_HIT, INFINITY},
    {0x1p+27f, {0x1p+20f, 0}, NO_HIT, INFINITY},
    // Behind the eye: no hit, and there was none before.
    {-64, {0.25f, 0}, NO_HIT, INFINITY},
    // The sphere that is hit so far is in this leaf, too.
    {64, {0.25f, 0.125f}, OF_THE_LEAFS_FIRST, 63.75f},
};
enum {
    N_LEAF_EDGES = COUNT(leaf_edges),
    OTHER_LEAFS_SPHERE = N_SHORT_LEAF_IDS - 1,
    // Where no rolled leaf's spheres are.
    FIRST_EDGE_SPHERE = OTHER_LEAFS_SPHERE - 2 * N_LEAF_EDGES,
};

static Vec3 along_axis(int axis, float length)
{
    return (Vec3){axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0};
}

// Put an edge into the place of leaf number i, between the guards that it has.
static void set_leaf(Inputs07 *inputs, int i, int edge)
{
    const u32 first = (u32)i * (LEAF_MAX_SPHERES + 2) + 1;
    const u32 guard = inputs->leaf_ids[first - 1];
    const float way = edge % 2 ? -1 : 1;
    const u32 id = FIRST_EDGE_SPHERE + 2 * (u32)edge;
    const u32 n_spheres = leaf_edges[edge].radii[1] == 0 ? 1 : 2;
    const Vec3 centre = along_axis(edge % 3, way * leaf_edges[edge].distance);
    for (u32 k = 0; k < n_spheres; k++) {
        inputs->leaf_spheres[id + k] =
            (Sphere){centre.x, centre.y, centre.z, leaf_edges[edge].radii[k]};
        inputs->leaf_ids[first + k] = id + k;
    }
    inputs->leaf_ids[first + n_spheres] = guard;
    inputs->leaf_spheres[guard] = (Sphere){0, 0, 0, GUARD_RADIUS};
    const SoFar so_far = leaf_edges[edge].so_far;
    inputs->leaves[i] =
        (SearchJob){.node = {.split_axis = KD_LEAF, .first = first, .n_spheres = n_spheres},
                    .direction = along_axis(edge % 3, way),
                    .t = leaf_edges[edge].t_so_far,
                    .sphere = so_far == NO_HIT            ? ORACLE_NO_SPHERE
                              : so_far == OF_ANOTHER_LEAF ? OTHER_LEAFS_SPHERE
                                                          : id};
}

// Of the spheres of a long leaf, all on one line, the last one is the nearest.
static void set_long_leaf(Inputs07 *inputs, int i)
{
    const u32 guard = inputs->leaf_ids[i * (LEAF_MAX_SPHERES + 2)];
    u32 *ids = inputs->leaf_ids + FIRST_LONG_ID;
    ids[0] = ids[N_LONG_LEAF + 1] = guard;
    for (u32 k = 0; k < N_LONG_LEAF; k++) {
        const float distance = k + 1 < N_LONG_LEAF ? 8 + (float)k : 4;
        ids[k + 1] = FIRST_LONG_ID + k;
        inputs->leaf_spheres[FIRST_LONG_ID + k] = (Sphere){0, distance, 0, 0.25f};
    }
    inputs->leaf_spheres[guard] = (Sphere){0, 0, 0, GUARD_RADIUS};
    inputs->leaves[i] = (SearchJob){
        .node = {.split_axis = KD_LEAF, .first = FIRST_LONG_ID + 1, .n_spheres = N_LONG_LEAF},
        .direction = {0, 1, 0},
        .t = INFINITY,
        .sphere = ORACLE_NO_SPHERE};
}

// ---- next_child ---------------------------------------------------------------------------------

// Both children are met, by our rules and by those of the stubs (tests/stubs), and one
// place is left on the stack.
static void set_children(Inputs07 *inputs)
{
    NextChildJob job = {.node = {.split_pos = 2, .split_axis = 1, .first = 7},
                        .origin = -1,
                        .inverse = 1,
                        .t_min = 1,
                        .t_max = 4,
                        .todo = {.n_lower = TODO_SIZE - STACK_ENTRIES, .n = TODO_SIZE - 1}};
    for (u32 i = 0; i < STACK_ENTRIES; i++) {
        const int waits = i + 1 < STACK_ENTRIES;
        job.todo.upper[i] = waits ? (TodoEntry){10 + i, 8, 9} : (TodoEntry){UNTOUCHED, 0, 0};
    }
    inputs->children[2 * N_CHILD_INPUTS - 1] = job;
}

// -------------------------------------------------------------------------------------------------

void inputs_07_set_edges(Inputs07 *inputs)
{
    set_clips(inputs);
    set_sides(inputs);
    set_planes(inputs);
    set_children(inputs);
    for (int edge = 0; edge < N_LEAF_EDGES; edge++) {
        set_leaf(inputs, N_LEAF_INPUTS - N_LEAF_EDGES + edge, edge);
        set_leaf(inputs, N_LEAVES - N_LEAF_EDGES + edge, edge);
    }
    set_long_leaf(inputs, N_LEAF_INPUTS - N_LEAF_EDGES - 1);
}
