// Drawings for people, as SVG: on a light ground, with text large enough for the last row, and
// readable in black and white. Used by what explains a lab: a followed pixel, the notes' figures.
//
// Read next: ray_svg.c of common/follow.
#ifndef COMMON_SVG_H
#define COMMON_SVG_H

#include <stdio.h>

// Pixels. All drawings are as wide, so that text of one size is read as one size.
enum { SVG_WIDTH = 1024, SVG_TEXT = 20, SVG_TITLE = 22 };

// Ink, in colours that differ in brightness as well: the palette of Okabe and Ito, and greys.
#define SVG_BLACK "#000000"
#define SVG_GREY "#767676"
#define SVG_PALE "#e6e6e6"
#define SVG_BLUE "#0072b2"
#define SVG_ORANGE "#d55e00"
#define SVG_SKY "#cfe8f7"
#define SVG_SAND "#f7dfb0"

// The look of text that lies over lines.
#define SVG_HALO "stroke=\"#ffffff\" stroke-width=\"6\" paint-order=\"stroke\""

typedef enum SvgAnchor { SVG_LEFT, SVG_MIDDLE, SVG_RIGHT } SvgAnchor;

// Begin and end a drawing SVG_WIDTH wide. `title` and `description` are read to those who cannot
// see it.
void svg_begin(FILE *file, int height, const char *title, const char *description);
// The same of another width, for a screen on which SVG_WIDTH would make its letters too small.
void svg_begin_wide(FILE *file, int width, int height, const char *title, const char *description);
void svg_end(FILE *file);

// A line of text, its baseline at y, its left end, middle or right end at x; `look` is further
// attributes (or ""). Anything may be in it. Of SVG_TEXT, or of a size.
__attribute__((format(printf, 6, 7))) void svg_text(FILE *file, double x, double y,
                                                    SvgAnchor anchor, const char *look,
                                                    const char *format, ...);
__attribute__((format(printf, 6, 7))) void svg_title(FILE *file, double x, double y,
                                                     SvgAnchor anchor, const char *look,
                                                     const char *format, ...);

// How wide a text of SVG_TEXT gets at most, for whether there is room.
double svg_text_width(const char *text);

// Shapes. `look` are attributes: `fill`, `stroke`, `stroke-width`, `stroke-dasharray`.
void svg_line(FILE *file, double x1, double y1, double x2, double y2, const char *look);
void svg_arrow(FILE *file, double x1, double y1, double x2, double y2, const char *look);
void svg_box(FILE *file, double x, double y, double width, double height, const char *look);
void svg_circle(FILE *file, double x, double y, double radius, const char *look);

// Many boxes of one look, as one path: begin it, add each box, end it. Strokes of neighbours that
// share a side are drawn there once.
void svg_boxes_begin(FILE *file, const char *look);
void svg_boxes_add(FILE *file, double x, double y, double width, double height);
void svg_boxes_end(FILE *file);

// What a drawing shows more than once: drawn between begin and end, then again, moved by (x, y). An
// id is unique in all drawings, as several can be on one page.
void svg_group_begin(FILE *file, const char *id, const char *look);
void svg_group_end(FILE *file);
void svg_use(FILE *file, const char *id, double x, double y);

// A cross, of a pixel's sample point or a point that is hit.
void svg_cross(FILE *file, double x, double y, double half, const char *look);

#endif
