// Drawing a cut through a 3D kd-tree, for lab 06's program and for the grader's report (see
// tree3d_draw.h).
//
// Three layers: the cells, shaded; the circles where the cut meets spheres; the cells' borders.
// Cells come from a walk down the tree for each pixel, circles from the spheres, so that a tree
// that lost one shows it: a circle on a cell that counts none. Read next: image.c.
#include "tree3d_draw.h"

#include "complain.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The scene's box keeps clear of the picture's sides by this share of the shorter one.
#define MARGIN (1.0 / 20)

// The fullest cell's place in the heat colours: dark enough for circles to stand out on it.
#define FULLEST 0.5f

// Cells are outlined from this many pixels on, the more clearly the larger they are, up to the
// second: outlines of smaller cells would leave nothing of what is inside.
#define FIRST_OUTLINED 3.0
#define FULLY_OUTLINED 14.0
#define OUTLINE_OPACITY 0.45

static const float BACKGROUND[3] = {0.10f, 0.11f, 0.13f};
static const float OUTLINE[3] = {0.85f, 0.88f, 0.92f};

// A circle has a dark rim this many pixels wide, so that it stands out on a cell of its own colour.
#define RIM_WIDTH 1.25
#define RIM_BRIGHTNESS 0.45f

// A large sphere covers many cells: their shades shine through.
#define CIRCLE_OPACITY 0.8

// Where the cut lies in the scene, and the scene in the picture.
typedef struct Cut {
    const Scene3D *scene;
    const KdTree3D *tree;
    int across, up, normal;  // axes: to the right, upwards, and at right angles to the cut
    double depth;            // the cut's coordinate on `normal`, scene units
    double left, top;        // scene coordinates of the picture's left and top sides
    double pixel;            // a pixel's side, scene units
} Cut;

// A side of the scene's box.
static double side(const BBox3D *box, int axis)
{
    return (double)box->max[axis] - box->min[axis];
}

static double middle(const BBox3D *box, int axis)
{
    return ((double)box->min[axis] + box->max[axis]) / 2;
}

// The coordinate of the box's middle on an axis; where no sphere is there, as between two layers of
// a lattice, that of the nearest sphere's centre.
static double find_depth(const Scene3D *scene, double wanted, int axis)
{
    double nearest = wanted, smallest = INFINITY;
    for (int i = 0; i < scene->n_spheres; i++) {
        const Sphere s = scene->spheres[i];
        const double centre = axis == 0 ? s.x : axis == 1 ? s.y : s.z;
        const double distance = fabs(centre - wanted);
        if (distance < fabs((double)s.radius)) {
            return wanted;
        }
        if (distance < smallest) {
            smallest = distance;
            nearest = centre;
        }
    }
    return nearest;
}

// Lay the cut through the box and fit it into the picture. Returns 0, or -1 when there is nothing
// to cut.
static int place_cut(const Scene3D *scene, const KdTree3D *tree, Cut *cut)
{
    static const int normals[] = {1, 2, 0};  // what the eye is used to: z upwards, x to the right
    const BBox3D *box = &tree->bounds;
    *cut = (Cut){.scene = scene, .tree = tree, .normal = normals[0]};
    for (int i = 1; i < 3; i++) {
        cut->normal = side(box, normals[i]) < side(box, cut->normal) ? normals[i] : cut->normal;
    }
    cut->across = cut->normal == 0 ? 1 : 0;
    cut->up = cut->normal == 2 ? 1 : 2;
    cut->depth = find_depth(scene, middle(box, cut->normal), cut->normal);

    const int shorter = scene->width < scene->height ? scene->width : scene->height;
    const double margin = 2 * MARGIN * shorter;
    cut->pixel = fmax(side(box, cut->across) / (scene->width - margin),
                      side(box, cut->up) / (scene->height - margin));
    cut->left = middle(box, cut->across) - cut->pixel * scene->width / 2;
    cut->top = middle(box, cut->up) + cut->pixel * scene->height / 2;
    return tree->n_nodes > 0 && cut->pixel > 0 ? 0 : -1;
}

// The picture's column and row of a scene coordinate; a pixel's middle is at a half.
static double column_of(const Cut *cut, double x)
{
    return (x - cut->left) / cut->pixel;
}

static double row_of(const Cut *cut, double y)
{
    return (cut->top - y) / cut->pixel;
}

// A column or row as a pixel's number, at most `size`: any number, also one far outside.
static int pixel_at(double place, int size)
{
    return (int)fmin(fmax(place, 0), size);
}

// Mix a colour over a pixel's.
static void blend(float *pixel, const float *color, double opacity)
{
    for (int c = 0; c < 3; c++) {
        pixel[c] += (float)opacity * (color[c] - pixel[c]);
    }
}

// ---- Cells --------------------------------------------------------------------------------------

// A leaf, and its cell in the picture: columns from x[0] to x[1], rows from y[0] to y[1].
typedef struct Cell {
    u32 leaf;
    double x[2], y[2];
} Cell;

// Walk down to the leaf at a place of the picture inside the box. On a plane, the upper side
// counts.
static Cell find_cell(const Cut *cut, double column, double row)
{
    const KdTree3D *tree = cut->tree;
    BBox3D box = tree->bounds;
    double point[3];
    point[cut->across] = cut->left + column * cut->pixel;
    point[cut->up] = cut->top - row * cut->pixel;
    point[cut->normal] = cut->depth;
    u32 id = 0;
    while (tree->nodes[id].split_axis != KD_LEAF) {
        const KdNode3 node = tree->nodes[id];
        const int is_higher = point[node.split_axis] >= (double)node.split_pos;
        (is_higher ? box.min : box.max)[node.split_axis] = node.split_pos;
        id = node.first + (u32)is_higher;
    }
    return (Cell){id,
                  {column_of(cut, box.min[cut->across]), column_of(cut, box.max[cut->across])},
                  {row_of(cut, box.max[cut->up]), row_of(cut, box.min[cut->up])}};
}

// What is done with a pixel that its cell meets.
typedef void VisitPixel(const Cell *cell, int u, int v, float *pixel, void *context);

// Visit every pixel of the scene's box with its cell.
static void visit_cells(const Cut *cut, Image *image, VisitPixel *visit, void *context)
{
    const BBox3D *box = &cut->tree->bounds;
    const double x[2] = {column_of(cut, box->min[cut->across]),
                         column_of(cut, box->max[cut->across])};
    const double y[2] = {row_of(cut, box->max[cut->up]), row_of(cut, box->min[cut->up])};
    for (int v = pixel_at(y[0], image->height); v < image->height && v <= y[1]; v++) {
        Cell cell = {.x = {0, -1}};  // nowhere
        for (int u = pixel_at(x[0], image->width); u < image->width && u <= x[1]; u++) {
            // The pixels on the box's sides have their middle outside at times.
            const double column = fmin(fmax(u + 0.5, x[0]), x[1]);
            if (column >= cell.x[1] || column < cell.x[0]) {
                cell = find_cell(cut, column, fmin(fmax(v + 0.5, y[0]), y[1]));
            }
            visit(&cell, u, v, image->pixels + ((size_t)v * image->width + u) * IMAGE_CHANNELS,
                  context);
        }
    }
}

// How many spheres the cells hold that one sees.
typedef struct Shading {
    const KdNode3 *nodes;
    u32 most;
} Shading;

static void find_most(const Cell *cell, int u, int v, float *pixel, void *context)
{
    (void)u, (void)v, (void)pixel;
    Shading *shading = context;
    const u32 n_spheres = shading->nodes[cell->leaf].n_spheres;
    shading->most = n_spheres > shading->most ? n_spheres : shading->most;
}

static void shade(const Cell *cell, int u, int v, float *pixel, void *context)
{
    (void)u, (void)v;
    const Shading *shading = context;
    const u32 n_spheres = shading->nodes[cell->leaf].n_spheres;
    const float share = n_spheres > 0 ? (float)n_spheres / (float)shading->most : 0;
    image_heat_colour(FULLEST * share, pixel);
}

// The pixels that a cell's sides fall into: a line of one pixel, shared with the neighbour.
static void outline(const Cell *cell, int u, int v, float *pixel, void *context)
{
    (void)context;
    const double shorter = fmin(cell->x[1] - cell->x[0], cell->y[1] - cell->y[0]);
    const double clarity = (shorter - FIRST_OUTLINED) / (FULLY_OUTLINED - FIRST_OUTLINED);
    if (floor(cell->x[0]) == u || floor(cell->x[1]) == u || floor(cell->y[0]) == v ||
        floor(cell->y[1]) == v) {
        blend(pixel, OUTLINE, OUTLINE_OPACITY * fmin(fmax(clarity, 0), 1));
    }
}

// ---- Circles ------------------------------------------------------------------------------------

// What the cut leaves of a sphere, in pixels.
typedef struct CutCircle {
    double x, y, radius;
    int sphere;
} CutCircle;

// The larger is painted first, so that it hides nothing that is inside it; of equal circles the
// sphere with the lower id comes last, on top.
static int paint_order(const void *a, const void *b)
{
    const CutCircle *one = a, *other = b;
    if (one->radius != other->radius) {
        return one->radius > other->radius ? -1 : 1;
    }
    return one->sphere > other->sphere ? -1 : 1;
}

// Circles at one place together, and of those of one size the lowest id first.
static int place_order(const void *a, const void *b)
{
    const CutCircle *one = a, *other = b;
    const double differences[] = {one->x - other->x, one->y - other->y, one->radius - other->radius,
                                  one->sphere - other->sphere};
    int order = 0;
    for (int i = 0; i < 4 && order == 0; i++) {
        order = (differences[i] > 0) - (differences[i] < 0);
    }
    return order;
}

// Leave only the lowest id of equal circles: of 100 000 one upon another one is seen. Returns how
// many are left.
static size_t drop_hidden(CutCircle *circles, size_t n)
{
    size_t n_left = 0;
    qsort(circles, n, sizeof *circles, place_order);
    for (size_t i = 0; i < n; i++) {
        const CutCircle *last = &circles[n_left - (n_left > 0)];
        if (n_left == 0 || circles[i].x != last->x || circles[i].y != last->y ||
            circles[i].radius != last->radius) {
            circles[n_left++] = circles[i];
        }
    }
    return n_left;
}

// Does the cut meet the sphere? Then sets its circle.
static int cut_sphere(const Cut *cut, int sphere, CutCircle *circle)
{
    const Sphere s = cut->scene->spheres[sphere];
    const double centre[3] = {s.x, s.y, s.z};
    const double distance = centre[cut->normal] - cut->depth;
    const double radius2 = (double)s.radius * s.radius - distance * distance;
    if (radius2 <= 0) {
        return 0;
    }
    *circle = (CutCircle){column_of(cut, centre[cut->across]), row_of(cut, centre[cut->up]),
                          sqrt(radius2) / cut->pixel, sphere};
    return 1;
}

// Paint a disc with a dark rim and soft edges.
static void paint_circle(const CutCircle *circle, const float *color, Image *image)
{
    const float rim[3] = {RIM_BRIGHTNESS * color[0], RIM_BRIGHTNESS * color[1],
                          RIM_BRIGHTNESS * color[2]};
    // One that is smaller than a pixel covers a part of it.
    const double opacity = CIRCLE_OPACITY * fmin(2 * circle->radius, 1);
    const double reach = circle->radius + 1;
    const int end_u = pixel_at(circle->x + reach, image->width);
    const int end_v = pixel_at(circle->y + reach, image->height);
    for (int v = pixel_at(circle->y - reach, image->height); v < end_v; v++) {
        for (int u = pixel_at(circle->x - reach, image->width); u < end_u; u++) {
            const double inside = circle->radius - hypot(u + 0.5 - circle->x, v + 0.5 - circle->y);
            if (inside <= -0.5) {
                continue;
            }
            float *pixel = image->pixels + ((size_t)v * image->width + u) * IMAGE_CHANNELS;
            float mixed[3] = {rim[0], rim[1], rim[2]};
            // Small circles are all rim, and would only be dark.
            const double fill = circle->radius > 3 * RIM_WIDTH ? inside - RIM_WIDTH + 0.5 : 1;
            blend(mixed, color, fmin(fmax(fill, 0), 1));
            blend(pixel, mixed, opacity * fmin(inside + 0.5, 1));
        }
    }
}

// Returns 0, or -1 after one message on stderr.
static int paint_circles(const Cut *cut, Image *image)
{
    const Scene3D *scene = cut->scene;
    CutCircle circle;
    size_t n = 0;
    for (int i = 0; i < scene->n_spheres; i++) {
        n += (size_t)cut_sphere(cut, i, &circle);
    }
    CutCircle *circles = malloc((n + 1) * sizeof *circles);
    if (circles == NULL) {
        complain("tree3d_draw: no memory for %zu circles", n);
        return -1;
    }
    n = 0;
    for (int i = 0; i < scene->n_spheres; i++) {
        n += (size_t)cut_sphere(cut, i, &circles[n]);
    }
    n = drop_hidden(circles, n);
    qsort(circles, n, sizeof *circles, paint_order);
    for (size_t i = 0; i < n; i++) {
        const Vec3 color = scene->materials[scene->material_ids[circles[i].sphere]].color;
        const float rgb[3] = {color.x, color.y, color.z};
        paint_circle(&circles[i], rgb, image);
    }
    free(circles);
    return 0;
}

int tree3d_draw(const Scene3D *scene, const KdTree3D *tree, Image *image)
{
    if (image_create(scene->width, scene->height, image) != 0) {
        return -1;
    }
    for (size_t i = 0; i < (size_t)image->width * image->height; i++) {
        memcpy(image->pixels + i * IMAGE_CHANNELS, BACKGROUND, sizeof BACKGROUND);
        image->pixels[i * IMAGE_CHANNELS + 3] = 1;
    }
    Cut cut;
    if (place_cut(scene, tree, &cut) != 0) {
        return 0;
    }
    Shading shading = {tree->nodes, 0};
    visit_cells(&cut, image, find_most, &shading);
    visit_cells(&cut, image, shade, &shading);
    if (paint_circles(&cut, image) != 0) {
        image_free(image);
        return -1;
    }
    visit_cells(&cut, image, outline, NULL);
    return 0;
}
