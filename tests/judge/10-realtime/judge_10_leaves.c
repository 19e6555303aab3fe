// Lab 10's tile_leaf: which leaf a tile is in, and how many steps were counted on the way there.
// The trees are those of judge_10_circles.c.
#include "judge_10.h"

#include "message.h"
#include "words.h"

// ---- Right --------------------------------------------------------------------------------------

static const TileNode *nodes_of(const Job10 *job, CircleTileJob tile)
{
    return job->circle_nodes + tile.first_node;
}

// The tile's first pixel on the axis that a node is split on.
static int pixel_at(TileNode node, CircleTileJob tile)
{
    return node.split_axis == 0 ? tile.x : tile.y;
}

// A search that ends after so many steps, or at an id beyond some number. No way is longer than
// the nodes are many.
//   mask   what is left of an id
static TileLeafAnswer searched(const Job10 *job, int i, u32 n_steps, u32 n_ids, u32 mask)
{
    const CircleTileJob tile = job->circle_tiles[i];
    const TileNode *nodes = nodes_of(job, tile);
    TileLeafAnswer way = {0, 0};
    while (way.n_steps < n_steps && way.leaf < n_ids && nodes[way.leaf].split_axis != KD_LEAF) {
        const TileNode node = nodes[way.leaf];
        way.leaf = (node.first + (pixel_at(node, tile) >= node.split_pos)) & mask;
        way.n_steps++;
    }
    return way;
}

static TileLeafAnswer after(const Job10 *job, int i, u32 n_steps)
{
    return searched(job, i, n_steps, UINT32_MAX, UINT32_MAX);
}

static TileLeafAnswer right_way(const Job10 *job, int i)
{
    return after(job, i, MOST_CIRCLE_NODES);
}

u32 leaf_10_of_tile(const Job10 *job, int i)
{
    return right_way(job, i).leaf;
}

#define GIVEN                                                                                      \
    const Job10 *in = job;                                                                         \
    const TileLeafAnswer found = ((const TileLeafAnswer *)answers)[i]
#define IS_FOUND(way) (found.leaf == (way).leaf)

RIGHT(is_leaf, IS_FOUND(right_way(in, i)))

// ---- Mistakes -----------------------------------------------------------------------------------

// Down the tree from the root, to the upper child of a `node` where that is what the expression
// says. `at` is the tile's pixel on the axis of the node.
#define TURNS(name, is_upper, ...)                                                                 \
    while (number == 0 && turned.n_steps < MOST_CIRCLE_NODES &&                                    \
           nodes[turned.leaf].split_axis != KD_LEAF) {                                             \
        const TileNode node = nodes[turned.leaf];                                                  \
        const int at = pixel_at(node, tile);                                                       \
        (void)at;                                                                                  \
        turned = (TileLeafAnswer){node.first + (u32)(is_upper), turned.n_steps + 1};               \
    }                                                                                              \
    ANSWERS(name, turned, __VA_ARGS__)

KNOWN_LIST(leaf_known)
{
    GIVEN;
    const CircleTileJob tile = in->circle_tiles[i];
    const TileNode *nodes = nodes_of(in, tile);
    const TileLeafAnswer right = right_way(in, i);
    TileLeafAnswer turned = {0, 0};

    TURNS(plane_is_lower, at > node.split_pos,
          "pixel split_pos is the first of the upper side, not the last of the lower one");
    TURNS(axes_swapped, (node.split_axis == 1 ? tile.x : tile.y) >= node.split_pos,
          "the axes are swapped: split_axis 0 is x");
    TURNS(sides_swapped, at < node.split_pos,
          "the sides are swapped: first is the child with the lower coordinates");
    TURNS(only_x, tile.x >= node.split_pos, "that is as if all planes were across x");
    TURNS(only_y, tile.y >= node.split_pos, "that is as if all planes were across y");
    TURNS(always_lower, 0, "that is as if the lower child were taken every time");
    TURNS(next_tile, at + CIRCLE_TILE_SIDE >= node.split_pos,
          "the first pixel behind the tile was asked: its own first one counts");
    TURNS(pixel_cut, (at & 0xffff) >= node.split_pos,
          "the pixel was cut to 16 bits or fewer: a picture may be larger");
    TURNS(tile_number, at / CIRCLE_TILE_SIDE >= node.split_pos,
          "the tile's number was compared with split_pos: both x and split_pos are pixels");

    ANSWERS(is_root, after(in, i, 0), "the search did not leave the root");
    ANSWERS(one_step, after(in, i, 1), "the search ended after one step, leaf or not");
    EACH(some_steps,
         IS_FOUND(after(in, i, 8)) || IS_FOUND(after(in, i, 10)) || IS_FOUND(after(in, i, 16)) ||
             IS_FOUND(after(in, i, 24)) || IS_FOUND(after(in, i, 32)) || IS_FOUND(after(in, i, 40)),
         "the search ended after some steps, leaf or not");
    ANSWERS(parent, after(in, i, right.n_steps > 0 ? right.n_steps - 1 : 0),
            "the search ended one node above the leaf");
    EACH(by_first, found.leaf == nodes[right.leaf].first,
         "that is the leaf's `first`, where its circles begin: its own id is asked for");
    ANSWERS(
        near_ids, searched(in, i, MOST_CIRCLE_NODES, FAR_NODE, UINT32_MAX),
        "the search ended at the first large id, leaf or not: a tree may have any number of nodes");

#define ID_CUT "the id was cut to 8 or 16 bits: a tree may have more nodes than these can number"
    ANSWERS(cut_8, searched(in, i, MOST_CIRCLE_NODES, UINT32_MAX, 0xff), ID_CUT);
    ANSWERS(cut_16, searched(in, i, MOST_CIRCLE_NODES, UINT32_MAX, 0xffff), ID_CUT);
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

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
    GIVEN;
    return message_new("%s: your code ends in node %u, expected the leaf %u",
                       tile_words(in, i).text, found.leaf, right_way(in, i).leaf);
}

const Function tile_leaf_10 = {"tile_leaves", N_CIRCLE_TILES, sizeof(TileLeafAnswer),
                               KNOWING(is_leaf, describe_leaf, leaf_known), .counted = "tiles"};
#undef IS_FOUND

// ---- Steps --------------------------------------------------------------------------------------

#define IS_FOUND(expected) (found.n_steps == (expected))

RIGHT(is_steps, IS_FOUND(right_way(in, i).n_steps))

KNOWN_LIST(steps_known)
{
    GIVEN;
    const TileLeafAnswer right = right_way(in, i);

    EACH(hidden, IS_FOUND(0) && found.leaf == right.leaf,
         "the way is right, but no step is counted: is_inner() says whether a node has children, "
         "and counts; or `work` was not passed on");
    ANSWERS(twice, 2 * right.n_steps,
            "each step is counted twice: ask is_inner() once for each node");
    ANSWERS(and_leaf, right.n_steps + 1,
            "the leaf is counted, too: a step is one from a node to its child");
    ONLY(elsewhere, found.leaf != right.leaf,
         "the way leads to another node there: leaf-tile says more");
    return NO_MORE;
}

static char *describe_steps(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("%s: found %u step%s counted, expected %u", tile_words(in, i).text,
                       found.n_steps, plural(found.n_steps), right_way(in, i).n_steps);
}

const Function leaf_steps_10 = {"tile_leaves", N_CIRCLE_TILES, sizeof(TileLeafAnswer),
                                KNOWING(is_steps, describe_steps, steps_known), .counted = "tiles"};
