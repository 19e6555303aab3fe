// Drawing a 2D kd-tree, for lab 02's program and for the grader's report (see tree2d_draw.h).
//
// Takes nothing on trust: the grader draws the trees of submissions. Read next: image.c.
#include "tree2d_draw.h"

#include "complain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Small scenes are magnified by the largest whole factor that keeps the longer side within this
// many pixels.
enum { DRAWING_SIZE = 640 };

// A cell is labelled with its node id when both sides are at least this long in the drawing.
enum { LABEL_MIN_SIZE = 24 };

static int drawing_scale(const Scene2D *scene)
{
    const int longer = scene->width > scene->height ? scene->width : scene->height;
    return longer < DRAWING_SIZE ? DRAWING_SIZE / longer : 1;
}

// Is the node a leaf whose cell can be drawn?
static int is_drawable(const KdTree2D *tree, u32 id)
{
    const BBox2D box = tree->nodes_BBox[id];
    return tree->nodes_flag[id] == LEAF && isfinite(box.minX) && isfinite(box.maxX) &&
           isfinite(box.minY) && isfinite(box.maxY) && box.minX < box.maxX && box.minY < box.maxY;
}

// The first and one past the last drawing pixel between two scene coordinates, inside [0, size].
static void pixel_range(double lowest, double highest, int scale, int size, int *first, int *end)
{
    *first = (int)fmin(fmax(ceil(lowest * scale), 0), size);
    *end = (int)fmin(fmax(floor(highest * scale) + 1, 0), size);
}

// Paint one circle where it is nearer than what depths[] holds, muted so that cell borders stand
// out.
static void paint_circle(Circle c, int scale, Image *image, float *depths)
{
    int first_x, end_x, first_y, end_y;
    pixel_range((double)c.x - c.radius, (double)c.x + c.radius, scale, image->width, &first_x,
                &end_x);
    pixel_range((double)c.y - c.radius, (double)c.y + c.radius, scale, image->height, &first_y,
                &end_y);
    for (int v = first_y; v < end_y; v++) {
        for (int u = first_x; u < end_x; u++) {
            const double dx = (double)u / scale - c.x, dy = (double)v / scale - c.y;
            const size_t pixel = (size_t)v * image->width + u;
            if (dx * dx + dy * dy <= (double)c.radius * c.radius && c.depth < depths[pixel]) {
                depths[pixel] = c.depth;
                const float color[IMAGE_CHANNELS] = {0.6f * c.r, 0.6f * c.g, 0.6f * c.b, 1};
                memcpy(image->pixels + pixel * IMAGE_CHANNELS, color, sizeof color);
            }
        }
    }
}

// Draw the border of a cell where it crosses the drawing.
static void outline_cell(BBox2D box, int scale, Image *image)
{
    const float color[IMAGE_CHANNELS] = {0.85f, 0.88f, 0.92f, 1};
    int first_x, end_x, first_y, end_y;
    pixel_range(box.minX, box.maxX, scale, image->width, &first_x, &end_x);
    pixel_range(box.minY, box.maxY, scale, image->height, &first_y, &end_y);
    for (int v = first_y; v < end_y; v++) {
        for (int u = first_x; u < end_x; u++) {
            // The upper and left border only: the others are drawn by the neighbours.
            if (u == ceil((double)box.minX * scale) || v == ceil((double)box.minY * scale)) {
                memcpy(image->pixels + ((size_t)v * image->width + u) * IMAGE_CHANNELS, color,
                       sizeof color);
            }
        }
    }
}

int tree2d_draw(const Scene2D *scene, const KdTree2D *tree, Image *image)
{
    const int scale = drawing_scale(scene);
    if (image_create(scene->width * scale, scene->height * scale, image) != 0) {
        return -1;
    }
    const size_t n_pixels = (size_t)image->width * image->height;
    float *depths = malloc(n_pixels * sizeof *depths);
    if (depths == NULL) {
        complain("tree2d_draw: no memory for %zu pixels", n_pixels);
        image_free(image);
        return -1;
    }
    for (size_t i = 0; i < n_pixels; i++) {
        const float background[IMAGE_CHANNELS] = {0.10f, 0.11f, 0.13f, 1};
        memcpy(image->pixels + i * IMAGE_CHANNELS, background, sizeof background);
        depths[i] = INFINITY;
    }
    for (int i = 0; i < scene->n_circles; i++) {
        paint_circle(scene->circles[i], scale, image, depths);
    }
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (is_drawable(tree, id)) {
            outline_cell(tree->nodes_BBox[id], scale, image);
        }
    }
    free(depths);
    return 0;
}

// A colour channel as SVG writes it, 0 to 255.
static int channel_byte(float value)
{
    return (int)lrintf(255 * fminf(fmaxf(value, 0), 1));
}

// Order indices of `circles` from the farthest to the nearest; of equal depths the lower index
// comes last, on top.
static int farther_first(const void *a, const void *b, void *circles)
{
    const int i = *(const int *)a, j = *(const int *)b;
    const Circle *h_circles = circles;
    const float depth_i = h_circles[i].depth, depth_j = h_circles[j].depth;
    return depth_i != depth_j ? (depth_i < depth_j ? 1 : -1) : (i < j ? 1 : -1);
}

static int write_circles(FILE *file, const Scene2D *scene, int scale)
{
    int *order = malloc((size_t)(scene->n_circles + 1) * sizeof *order);
    if (order == NULL) {
        complain("tree2d_write_svg: no memory for %d circles", scene->n_circles);
        return -1;
    }
    for (int i = 0; i < scene->n_circles; i++) {
        order[i] = i;
    }
    qsort_r(order, (size_t)scene->n_circles, sizeof *order, farther_first, scene->circles);
    for (int i = 0; i < scene->n_circles; i++) {
        const Circle c = scene->circles[order[i]];
        fprintf(file, "<circle cx=\"%g\" cy=\"%g\" r=\"%g\" fill=\"#%02x%02x%02x\"/>\n",
                (double)c.x * scale, (double)c.y * scale, (double)c.radius * scale,
                channel_byte(c.r), channel_byte(c.g), channel_byte(c.b));
    }
    free(order);
    return 0;
}

int tree2d_write_svg(FILE *file, const Scene2D *scene, const KdTree2D *tree)
{
    const int scale = drawing_scale(scene);
    const int width = scene->width * scale, height = scene->height * scale;
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
            "viewBox=\"0 0 %d %d\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#1a1c21\"/>\n"
            "<g opacity=\"0.6\">\n",
            width, height, width, height);
    if (write_circles(file, scene, scale) != 0) {
        return -1;
    }
    fprintf(file, "</g>\n<path fill=\"none\" stroke=\"#d9e0eb\" stroke-width=\"1\" d=\"");
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (is_drawable(tree, id)) {
            const BBox2D box = tree->nodes_BBox[id];
            fprintf(file, "M%g %gH%gV%gH%gz", (double)box.minX * scale, (double)box.minY * scale,
                    (double)box.maxX * scale, (double)box.maxY * scale, (double)box.minX * scale);
        }
    }
    fprintf(file, "\"/>\n<g fill=\"#ffffff\" font-family=\"sans-serif\" font-size=\"12\">\n");
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const BBox2D box = tree->nodes_BBox[id];
        if (is_drawable(tree, id) && (box.maxX - box.minX) * scale >= LABEL_MIN_SIZE &&
            (box.maxY - box.minY) * scale >= LABEL_MIN_SIZE) {
            fprintf(file, "<text x=\"%g\" y=\"%g\">%u</text>\n", (double)box.minX * scale + 4,
                    (double)box.minY * scale + 14, id);
        }
    }
    fprintf(file, "</g>\n</svg>\n");
    return ferror(file) ? -1 : 0;
}
