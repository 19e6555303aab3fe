// Brute force in double precision: every pixel asks every circle, in the order of the array.
#include "oracle2d.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double distance_squared(Circle c, double x, double y)
{
    return (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y);
}

int oracle2d_covers(Circle circle, double x, double y)
{
    return distance_squared(circle, x, y) <= (double)circle.radius * circle.radius;
}

// Is a double a float, too?
static int is_float(double value)
{
    return (double)(float)value == value;
}

// Not where each step comes out exact, as on the 1/16 px grid; else where the two sides differ by
// less than the rounding of five float operations (each at most 2^-24 of the sum), and where float
// cannot hold a square: it is infinite then, or so small that it may be taken for 0.
int oracle2d_is_ambiguous(Circle c, double x, double y)
{
    const double dx = x - c.x, dy = y - c.y, radius_squared = (double)c.radius * c.radius;
    const double sum = dx * dx + dy * dy;
    if (is_float(dx) && is_float(dy) && is_float(dx * dx) && is_float(dy * dy) && is_float(sum) &&
        is_float(radius_squared)) {
        return 0;
    }
    return sum + radius_squared > FLT_MAX ||
           fabs(sum - radius_squared) <= 5 * 0x1p-24 * (sum + radius_squared) + 4 * FLT_MIN;
}

// Is a circle's colour 0 in these channels? In none of them it never is.
static int is_zero(const Circle *circle, u32 channels)
{
    const u32 zeros = (circle->r == 0 ? CHANNEL_R : 0u) | (circle->g == 0 ? CHANNEL_G : 0u) |
                      (circle->b == 0 ? CHANNEL_B : 0u) | (circle->a == 0 ? CHANNEL_A : 0u);
    return channels != 0 && (zeros & channels) == channels;
}

// Does this circle take the pixel from the one found so far (NULL: none)?
static int takes_pixel(const Circle *circle, const Circle *found, const OracleRules *rules)
{
    if ((rules->too_far != 0 && circle->depth >= rules->too_far) ||
        (rules->clear_is_hidden && circle->a == 0)) {
        return 0;
    }
    if (found == NULL || rules->ignore_depth || (rules->negative_is_none && found->depth < 0) ||
        is_zero(found, rules->zero_is_none)) {
        return 1;
    }
    if (rules->first_wins) {
        return 0;
    }
    if (rules->farthest_wins) {
        return circle->depth > found->depth;
    }
    return rules->later_wins_ties ? circle->depth <= found->depth : circle->depth < found->depth;
}

// Do circles that do not cover a pixel change what others may do there?
static int limits_all(const OracleRules *rules)
{
    return rules->all_limit || rules->last_limits;
}

// Is it hidden by circles that need not cover anything? Theirs is the limit, which it changes.
static int is_hidden(const Circle *circle, const OracleRules *rules, double *limit)
{
    if (!limits_all(rules)) {
        return 0;
    }
    const int is_behind = !(circle->depth < *limit);
    *limit = rules->last_limits ? circle->depth : fmin(*limit, circle->depth);
    return is_behind;
}

static double radius_of(Circle circle, const OracleRules *rules)
{
    return rules->diameter ? circle.radius / 2.0 : circle.radius;
}

static int covers(Circle circle, double x, double y, const OracleRules *rules)
{
    const double radius = radius_of(circle, rules);
    if (rules->covers_all) {
        return 1;
    }
    if (rules->squares) {
        return fmax(fabs(x - circle.x), fabs(y - circle.y)) <= radius;
    }
    const double sum = distance_squared(circle, x, y);
    return rules->strict_boundary ? sum < radius * radius : sum <= radius * radius;
}

// Is number i of n circles, or of a list, no longer asked?
static int is_end(u32 i, u32 n, const Circle *found, const OracleRules *rules)
{
    return i + rules->skip_last >= n || (rules->most_asked != 0 && i >= rules->most_asked) ||
           (rules->ends_at_0 && found != NULL && found->depth <= 0);
}

static void color_set(Image *image, int u, int v, const Circle *found)
{
    const float color[IMAGE_CHANNELS] = {found ? found->r : 0, found ? found->g : 0,
                                         found ? found->b : 0, found ? found->a : 0};
    memcpy(image->pixels + ((size_t)v * image->width + u) * IMAGE_CHANNELS, color, sizeof color);
}

// The circles that reach a row, into `ids`; returns how many there are. Any other one is too far
// above or below for all of its pixels: distance_squared() is rounded, but never below the square
// of one of its two parts.
static u32 circles_of_row(const Circle *circles, u32 n_circles, double y, const OracleRules *rules,
                          u32 *ids)
{
    u32 n = 0;
    for (u32 i = 0; i < n_circles; i++) {
        const double radius = radius_of(circles[i], rules);
        if ((y - circles[i].y) * (y - circles[i].y) <= radius * radius) {
            ids[n++] = i;
        }
    }
    return n;
}

// The circle that is drawn at a point, among those of `ids` or, where it is NULL, among all.
static const Circle *find_circle(const Circle *circles, u32 n_circles, const u32 *ids, u32 n_ids,
                                 double x, double y, const OracleRules *rules)
{
    const Circle *found = NULL;
    double limit = INFINITY;
    for (u32 k = 0; k < n_ids; k++) {
        const u32 i = ids != NULL ? ids[k] : k;
        if (is_end(i, n_circles, found, rules)) {
            break;
        }
        if (i >= (u32)rules->skip_first && !is_hidden(&circles[i], rules, &limit) &&
            covers(circles[i], x, y, rules) && takes_pixel(&circles[i], found, rules)) {
            found = &circles[i];
        } else if (rules->ends_at_miss) {
            break;
        }
    }
    return rules->first_is_nobody && found == circles ? NULL : found;
}

// May float arithmetic decide otherwise for one of the circles?
static int is_near_edge(const Circle *circles, int n_circles, double x, double y)
{
    int is_near = 0;
    for (int i = 0; i < n_circles && !is_near; i++) {
        is_near = oracle2d_is_ambiguous(circles[i], x, y);
    }
    return is_near;
}

void oracle2d_draw(const Circle *circles, int n_circles, const OracleRules *rules, Image *image,
                   unsigned char *ambiguous)
{
    const u32 n = (u32)n_circles;
    OracleRules limited = *rules;
    if (rules->first_is_limit && n_circles > 0) {
        limited.too_far = circles[0].depth;
    }
    // Every pixel asks every circle in the right picture, where all circles count, and where memory
    // lacks; else those that reach its row.
    const int asks_all =
        ambiguous != NULL || limits_all(rules) || rules->ends_at_miss || rules->covers_all;
    u32 *ids = asks_all ? NULL : malloc(n * sizeof *ids + 1);
    for (int v = 0; v < image->height; v++) {
        const double y = v + rules->sample_offset;
        const u32 n_ids = ids != NULL ? circles_of_row(circles, n, y, rules, ids) : n;
        for (int u = 0; u < image->width; u++) {
            const double x = u + rules->sample_offset;
            color_set(image, u, v, find_circle(circles, n, ids, n_ids, x, y, &limited));
            if (ambiguous != NULL) {
                ambiguous[(size_t)v * (size_t)image->width + (size_t)u] =
                    (unsigned char)is_near_edge(circles, n_circles, x, y);
            }
        }
    }
    free(ids);
}

// The list of the leaf whose half-open cell holds the point: a count, then ids. NULL outside.
static const u32 *list_at(const KdTree2D *tree, double x, double y)
{
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const BBox2D cell = tree->nodes_BBox[id];
        if (tree->nodes_flag[id] == LEAF && x >= cell.minX && x < cell.maxX && y >= cell.minY &&
            y < cell.maxY) {
            return tree->mapNode2Circles + tree->nodes_Relations[id].circleMapOffset;
        }
    }
    return NULL;
}

// How many of a list's entries are asked.
static u32 n_asked(const KdTree2D *tree, const u32 *list, const OracleRules *rules)
{
    const u32 n = list != NULL ? list[0] : 0;
    if (list == NULL || rules->count_is_end == 0) {
        return n;
    }
    const u32 n_before = (u32)(list - tree->mapNode2Circles) + rules->count_is_end - 1;
    return n > n_before ? n - n_before : 0;
}

// The id that is asked for entry i of a list in the tree's map.
static u32 id_of_entry(const KdTree2D *tree, const u32 *list, u32 i, OracleId id)
{
    return id == ID_PLACE_FROM_0   ? i - 1
           : id == ID_PLACE_FROM_1 ? i
           : id == ID_PLACE_IN_MAP ? (u32)(list - tree->mapNode2Circles) + i
           : id == ID_BEFORE       ? list[i - 1]
                                   : list[i];
}

void oracle2d_draw_leaves(const Circle *circles, int n_circles, const KdTree2D *tree,
                          const OracleRules *rules, Image *image, float *tolerances)
{
    for (int v = 0; v < image->height; v++) {
        for (int u = 0; u < image->width; u++) {
            const u32 *list = rules->first_list ? tree->mapNode2Circles : list_at(tree, u, v);
            const u32 n = n_asked(tree, list, rules);
            const Circle *found = NULL;
            double limit = INFINITY;
            const int x = rules->transposed ? v : u, y = rules->transposed ? u : v;
            for (u32 i = (u32)rules->skip_first; !is_end(i, n, found, rules); i++) {
                const u32 *ids = rules->first_ids ? tree->mapNode2Circles : list;
                const u32 id = id_of_entry(tree, ids, 1 + i, rules->id);
                if (id >= (u32)n_circles) {
                    tolerances[(size_t)v * (size_t)image->width + (size_t)u] = INFINITY;
                    continue;
                }
                const Circle *circle = &circles[id];
                if (!is_hidden(circle, rules, &limit) && covers(*circle, x, y, rules) &&
                    takes_pixel(circle, found, rules)) {
                    found = circle;
                } else if (rules->ends_at_miss) {
                    break;
                }
            }
            color_set(image, u, v, found);
        }
    }
}

int oracle2d_overlaps_box(Circle circle, BBox2D box)
{
    // How far the centre is outside the box on each axis; 0 when it is level with it.
    double dx = 0, dy = 0;
    if (circle.x < box.minX) {
        dx = (double)box.minX - circle.x;
    } else if (circle.x > box.maxX) {
        dx = (double)circle.x - box.maxX;
    }
    if (circle.y < box.minY) {
        dy = (double)box.minY - circle.y;
    } else if (circle.y > box.maxY) {
        dy = (double)circle.y - box.maxY;
    }
    const double radius = circle.radius;
    return dx * dx + dy * dy <= radius * radius;
}
