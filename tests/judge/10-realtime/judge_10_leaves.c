// Lab 10's tile_leaf: which leaf a tile is in, and how many steps were counted on the way there.
// The trees are those of judge_10_circles.c.
#include "judge_10.h"

#include "message.h"
#include "words.h"

// ---- The leaf -----------------------------------------------------------------------------------

enum {
    LEAF_PLANE_IS_LOWER = 1,
    LEAF_AXES_SWAPPED,
    LEAF_SIDES_SWAPPED,
    LEAF_ONLY_X,
    LEAF_ONLY_Y,
    LEAF_ALWAYS_LOWER,
    LEAF_ONE_STEP,
    LEAF_IS_ROOT,
    LEAF_OF_NEXT_TILE,
    LEAF_8_STEPS,
    LEAF_10_STEPS,
    LEAF_16_STEPS,
    LEAF_NEAR_IDS,
    LEAF_8_BITS,
    LEAF_16_BITS,
    LEAF_24_STEPS,
    LEAF_32_STEPS,
    LEAF_40_STEPS,
    LEAF_PIXEL_CUT,
    LEAF_TILE_NUMBER,
    LEAF_PARENT,
    LEAF_FIRST,
};
#define STEPS_END "the search ended after some steps, leaf or not"
#define ID_CUT "the id was cut to 8 or 16 bits: a tree may have more nodes than these can number"
static const Cause leaf_mistakes[] = {
    [LEAF_PLANE_IS_LOWER] = {.says = "pixel split_pos is the first of the upper side, not the last "
                                     "of the lower one"},
    [LEAF_AXES_SWAPPED] = {.says = "the axes are swapped: split_axis 0 is x"},
    [LEAF_SIDES_SWAPPED] = {.says = "the sides are swapped: first is the child with the lower "
                                    "coordinates"},
    [LEAF_ONLY_X] = {.says = "that is as if all planes were across x"},
    [LEAF_ONLY_Y] = {.says = "that is as if all planes were across y"},
    [LEAF_ALWAYS_LOWER] = {.says = "that is as if the lower child were taken every time"},
    [LEAF_ONE_STEP] = {.says = "the search ended after one step, leaf or not"},
    [LEAF_8_STEPS] = {.says = STEPS_END},
    [LEAF_10_STEPS] = {.says = STEPS_END},
    [LEAF_16_STEPS] = {.says = STEPS_END},
    [LEAF_24_STEPS] = {.says = STEPS_END},
    [LEAF_32_STEPS] = {.says = STEPS_END},
    [LEAF_40_STEPS] = {.says = STEPS_END},
    [LEAF_PIXEL_CUT] = {.says = "the pixel was cut to 16 bits or fewer: a picture may be larger"},
    [LEAF_TILE_NUMBER] = {.says = "the tile's number was compared with split_pos: both x and "
                                  "split_pos are pixels"},
    [LEAF_PARENT] = {.says = "the search ended one node above the leaf"},
    [LEAF_FIRST] = {.says = "that is the leaf's `first`, where its circles begin: its own id is "
                            "asked for"},
    [LEAF_OF_NEXT_TILE] = {.says = "the first pixel behind the tile was asked: its own first one "
                                   "counts"},
    [LEAF_IS_ROOT] = {.says = "the search did not leave the root"},
    [LEAF_NEAR_IDS] = {.says = "the search ended at the first large id, leaf or not: a tree may "
                               "have any number of nodes"},
    [LEAF_8_BITS] = {.says = ID_CUT},
    [LEAF_16_BITS] = {.says = ID_CUT},
};

// What a mistake leaves of an id.
static u32 id_mask(int mistake)
{
    return mistake == LEAF_8_BITS ? 0xff : mistake == LEAF_16_BITS ? 0xffff : UINT32_MAX;
}

// After how many steps a mistake ends the search; no way is longer than the nodes are many.
static int most_steps(int mistake)
{
    return mistake == LEAF_IS_ROOT    ? 0
           : mistake == LEAF_ONE_STEP ? 1
           : mistake == LEAF_8_STEPS  ? 8
           : mistake == LEAF_10_STEPS ? 10
           : mistake == LEAF_16_STEPS ? 16
           : mistake == LEAF_24_STEPS ? 24
           : mistake == LEAF_32_STEPS ? 32
           : mistake == LEAF_40_STEPS ? 40
                                      : MOST_CIRCLE_NODES;
}

static TileLeafAnswer expected_leaf(const Job10 *job, int i, int mistake)
{
    const CircleTileJob tile = job->circle_tiles[i];
    const TileNode *nodes = job->circle_nodes + tile.first_node;
    const u32 n_ids = mistake == LEAF_NEAR_IDS ? FAR_NODE : UINT32_MAX;
    TileLeafAnswer way = {0, 0};
    while ((int)way.n_steps < most_steps(mistake) && way.leaf < n_ids &&
           nodes[way.leaf].split_axis != KD_LEAF) {
        const TileNode node = nodes[way.leaf];
        const int is_x = mistake == LEAF_AXES_SWAPPED ? node.split_axis == 1
                         : mistake == LEAF_ONLY_X     ? 1
                         : mistake == LEAF_ONLY_Y     ? 0
                                                      : node.split_axis == 0;
        const int beyond = mistake == LEAF_OF_NEXT_TILE ? CIRCLE_TILE_SIDE : 0;
        const int whole = (is_x ? tile.x : tile.y) + beyond;
        const int at = mistake == LEAF_PIXEL_CUT     ? whole & 0xffff
                       : mistake == LEAF_TILE_NUMBER ? whole / CIRCLE_TILE_SIDE
                                                     : whole;
        const int is_upper = mistake == LEAF_PLANE_IS_LOWER  ? at > node.split_pos
                             : mistake == LEAF_SIDES_SWAPPED ? at < node.split_pos
                             : mistake == LEAF_ALWAYS_LOWER  ? 0
                                                             : at >= node.split_pos;
        const u32 next = (node.first + (u32)is_upper) & id_mask(mistake);
        if (mistake == LEAF_PARENT && nodes[next].split_axis == KD_LEAF) {
            return way;
        }
        way.leaf = next;
        way.n_steps++;
    }
    way.leaf = mistake == LEAF_FIRST ? nodes[way.leaf].first : way.leaf;
    return way;
}

u32 leaf_10_of_tile(const Job10 *job, int i)
{
    return expected_leaf(job, i, 0).leaf;
}

static int leaf_agrees(const void *job, int i, const void *answers, int mistake)
{
    return ((const TileLeafAnswer *)answers)[i].leaf == expected_leaf(job, i, mistake).leaf;
}

// "the tile from pixel (16, 0) on, in a tree whose root is a leaf".
static Words tile_words(const Job10 *job, int i)
{
    const CircleTileJob tile = job->circle_tiles[i];
    const u32 root_axis = job->circle_nodes[tile.first_node].split_axis;
    return words("the tile from pixel (%d, %d) on, in a tree whose root is %s", tile.x, tile.y,
                 root_axis == KD_LEAF ? "a leaf"
                 : root_axis == 0     ? "split across x"
                                      : "split across y");
}

static char *describe_leaf(const void *job, int i, const void *answers)
{
    return message_new("%s: found node %u, expected the leaf %u", tile_words(job, i).text,
                       ((const TileLeafAnswer *)answers)[i].leaf, leaf_10_of_tile(job, i));
}

const Function tile_leaf_10 = {"tile_leaves", N_CIRCLE_TILES, sizeof(TileLeafAnswer),
                               COMPARED(leaf_agrees, describe_leaf, leaf_mistakes),
                               .counted = "tiles"};

// ---- Steps --------------------------------------------------------------------------------------

enum { STEPS_HIDDEN = 1, STEPS_TWICE, STEPS_AND_LEAF, STEPS_ELSEWHERE };
static const Cause steps_mistakes[] = {
    [STEPS_HIDDEN] = {.says = "no step is counted: is_inner() says whether a node has children, "
                              "and counts; or `work` was not passed on"},
    [STEPS_TWICE] = {.says = "each step is counted twice: ask is_inner() once for each node"},
    [STEPS_AND_LEAF] = {.says = "the leaf is counted, too: a step is one from a node to its child"},
    [STEPS_ELSEWHERE] = {.says = "the way leads to another node there: leaf-tile says more"},
};

static u32 expected_steps(const Job10 *job, int i, int mistake)
{
    const u32 n_steps = expected_leaf(job, i, 0).n_steps;
    return mistake == STEPS_HIDDEN     ? 0
           : mistake == STEPS_TWICE    ? 2 * n_steps
           : mistake == STEPS_AND_LEAF ? n_steps + 1
                                       : n_steps;
}

static int steps_agree(const void *job, int i, const void *answers, int mistake)
{
    const TileLeafAnswer *found = (const TileLeafAnswer *)answers + i;
    return (mistake == STEPS_ELSEWHERE && found->leaf != leaf_10_of_tile(job, i)) ||
           found->n_steps == expected_steps(job, i, mistake);
}

static char *describe_steps(const void *job, int i, const void *answers)
{
    const u32 found = ((const TileLeafAnswer *)answers)[i].n_steps;
    return message_new("%s: found %u step%s counted, expected %u", tile_words(job, i).text, found,
                       plural(found), expected_steps(job, i, 0));
}

const Function leaf_steps_10 = {"tile_leaves", N_CIRCLE_TILES, sizeof(TileLeafAnswer),
                                COMPARED(steps_agree, describe_steps, steps_mistakes),
                                .counted = "tiles"};
