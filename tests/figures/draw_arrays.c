// 02-arrays.svg: the same tree packed, and which entry names which.
#include "figures2d.h"

#include "lab.h"

// Rows and columns of the tables. Pixels.
enum { LEFT = 206, TOP = 100, ROW = 34, COLUMN = 53, LIST_COLUMN = 38, LIST_TOP = 472 };
enum { HEIGHT = LIST_TOP + 2 * ROW + 50 };

// The rows of the upper table.
enum { FLAG, ID, LEFT_CHILD, RIGHT_CHILD, OFFSET, MIN_X, MAX_X, MIN_Y, MAX_Y, N_ROWS };

static double column_x(u32 column, int width)
{
    return LEFT + (column + 0.5) * width;
}

// Entries of the arrays, which are drawn together: boxes of one look are one path.
typedef struct Entry {
    u32 column;
    int width;
    double y, value;
    const char *look;
} Entry;

typedef struct Entries {
    Entry all[256];
    int n;
} Entries;

static void entry_add(Entries *entries, Entry entry)
{
    require(entries->n < (int)(sizeof entries->all / sizeof *entries->all) ? 0 : -1);
    entries->all[entries->n++] = entry;
}

static void entries_draw(FILE *file, const Entries *entries, const char *const *looks,
                         size_t n_looks)
{
    for (size_t look = 0; look < n_looks; look++) {
        svg_boxes_begin(file, looks[look]);
        for (int i = 0; i < entries->n; i++) {
            const Entry *entry = &entries->all[i];
            if (entry->look == looks[look]) {
                svg_boxes_add(file, LEFT + (double)entry->column * entry->width, entry->y,
                              entry->width, ROW);
            }
        }
        svg_boxes_end(file);
    }
    for (int i = 0; i < entries->n; i++) {
        const Entry *entry = &entries->all[i];
        svg_text(file, column_x(entry->column, entry->width), entry->y + 25, SVG_MIDDLE, "", "%g",
                 entry->value);
    }
}

// What an entry is: the rule, one that means nothing, a list's count, or one of the marked leaf.
static const char FULL[] = "fill=\"#ffffff\" stroke=\"" SVG_BLACK "\"";
static const char EMPTY[] = "fill=\"" SVG_PALE "\" stroke=\"" SVG_BLACK "\"";
static const char IN_MARKED[] = "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\"";
static const char MARKED[] = "fill=\"" SVG_SAND "\" stroke=\"" SVG_BLACK "\" stroke-width=\"3\"";
static const char *const LOOKS[] = {FULL, EMPTY, IN_MARKED, MARKED};

static double row_y(int row)
{
    // A gap between arrays.
    return TOP + row * ROW + (row >= ID ? 10 : 0) + (row >= MIN_X ? 10 : 0);
}

// Entries that mean nothing, of leaves and of inner nodes, are pale.
static void node_add(Entries *entries, const KdTree2D *tree, u32 id, int is_marked)
{
    const NodeRel node = tree->nodes_Relations[id];
    const BBox2D box = tree->nodes_BBox[id];
    const int is_leaf = tree->nodes_flag[id] == LEAF;
    const char *full = is_marked ? MARKED : FULL;
    const double values[N_ROWS] = {tree->nodes_flag[id],
                                   node.id,
                                   node.lChild,
                                   node.rChild,
                                   node.circleMapOffset,
                                   box.minX,
                                   box.maxX,
                                   box.minY,
                                   box.maxY};
    for (int row = 0; row < N_ROWS; row++) {
        const int is_empty = row == OFFSET                             ? !is_leaf
                             : row == LEFT_CHILD || row == RIGHT_CHILD ? is_leaf
                                                                       : 0;
        entry_add(entries, (Entry){id, COLUMN, row_y(row), values[row], is_empty ? EMPTY : full});
    }
}

static void labels_draw(FILE *file)
{
    static const char *const ROWS[N_ROWS] = {
        "nodes_flag", "id", "lChild", "rChild", "circleMapOffset", "minX", "maxX", "minY", "maxY"};
    for (int row = 0; row < N_ROWS; row++) {
        svg_text(file, LEFT - 10, row_y(row) + 25, SVG_RIGHT, "", "%s", ROWS[row]);
    }
    svg_text(file, LEFT - 10, LIST_TOP + 25, SVG_RIGHT, "", "mapNode2Circles");
    svg_text(file, LEFT - 10, TOP - 12, SVG_RIGHT, "fill=\"" SVG_GREY "\"", "position");
    svg_text(file, LEFT - 10, LIST_TOP + ROW + 25, SVG_RIGHT, "fill=\"" SVG_GREY "\"", "position");
}

// From each leaf's offset to its list, which a thick line begins.
static void arrows_draw(FILE *file, const KdTree2D *tree, u32 marked)
{
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (tree->nodes_flag[id] == LEAF) {
            const u32 offset = tree->nodes_Relations[id].circleMapOffset;
            const double x = LEFT + (double)offset * LIST_COLUMN;
            svg_line(file, x, LIST_TOP, x, LIST_TOP + ROW,
                     "stroke=\"" SVG_BLACK "\" stroke-width=\"4\"");
            svg_arrow(file, column_x(id, COLUMN), row_y(MAX_Y) + ROW, column_x(offset, LIST_COLUMN),
                      LIST_TOP - 2, id == marked ? "stroke-width=\"4\"" : "stroke-width=\"1.5\"");
        }
    }
}

static void list_add(FILE *file, Entries *entries, const KdTree2D *tree, u32 marked)
{
    u32 leaf = 0;
    for (u32 i = 0; i < tree->n_map; i++) {
        int is_count = 0;
        for (u32 id = 0; id < tree->n_nodes; id++) {
            if (tree->nodes_flag[id] == LEAF && tree->nodes_Relations[id].circleMapOffset == i) {
                is_count = 1;
                leaf = id;
            }
        }
        const char *look = leaf == marked ? IN_MARKED : is_count ? EMPTY : FULL;
        entry_add(entries, (Entry){i, LIST_COLUMN, LIST_TOP, tree->mapNode2Circles[i], look});
        svg_text(file, column_x(i, LIST_COLUMN), LIST_TOP + ROW + 25, SVG_MIDDLE,
                 "fill=\"" SVG_GREY "\"", "%u", i);
    }
}

void draw_arrays(FILE *file, const Followed *followed)
{
    const KdTree2D *tree = followed->world->kind->data(followed->world).tree2d;
    const u32 marked = followed_leaf(followed);
    Entries entries = {.n = 0};
    svg_begin(
        file, HEIGHT, "The worked example: the packed arrays",
        "A table with a column for each node, 0 to 14: its flag, its children, its offset, its "
        "cell. Below it the 21 entries of mapNode2Circles. An arrow leads from each leaf's offset "
        "to the count that its list begins with; that of leaf 13 is marked.");
    svg_title(file, 16, 40, SVG_LEFT, "",
              "A column is a node; a leaf's offset says where its list is");
    labels_draw(file);
    for (u32 id = 0; id < tree->n_nodes; id++) {
        svg_text(file, column_x(id, COLUMN), TOP - 12, SVG_MIDDLE, "fill=\"" SVG_GREY "\"", "%u",
                 id);
        node_add(&entries, tree, id, id == marked);
    }
    list_add(file, &entries, tree, marked);
    entries_draw(file, &entries, LOOKS, sizeof LOOKS / sizeof *LOOKS);
    arrows_draw(file, tree, marked);
    svg_text(file, 24, LIST_TOP + 2 * ROW + 34, SVG_LEFT, "",
             "Grey entries: left, a count; above, what means nothing in this node.");
    svg_end(file);
}
