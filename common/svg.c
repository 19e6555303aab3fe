// Drawings for people (see svg.h).
#include "svg.h"

#include "utf8.h"

#include <stdarg.h>

// A letter's share of its size: of DejaVu Sans hardly any line of text is wider.
static const double LETTER = 0.62;

static void print_escaped(FILE *file, const char *text)
{
    for (; *text != '\0'; text++) {
        switch (*text) {
        case '<':
            fputs("&lt;", file);
            break;
        case '>':
            fputs("&gt;", file);
            break;
        case '&':
            fputs("&amp;", file);
            break;
        default:
            fputc(*text, file);
        }
    }
}

void svg_begin_wide(FILE *file, int width, int height, const char *title, const char *description)
{
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"%d\" height=\"%d\" "
            "viewBox=\"0 0 %d %d\" font-family=\"DejaVu Sans, Verdana, sans-serif\" "
            "font-size=\"%d\">\n<title>",
            width, height, width, height, SVG_TEXT);
    print_escaped(file, title);
    fputs("</title>\n<desc>", file);
    print_escaped(file, description);
    fputs("</desc>\n"
          "<defs><marker id=\"head\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" "
          "markerUnits=\"userSpaceOnUse\" "
          "markerWidth=\"14\" markerHeight=\"14\" orient=\"auto\"><path d=\"M0 0L10 5L0 "
          "10z\"/></marker></defs>\n"
          "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
          file);
}

void svg_begin(FILE *file, int height, const char *title, const char *description)
{
    svg_begin_wide(file, SVG_WIDTH, height, title, description);
}

void svg_end(FILE *file)
{
    fputs("</svg>\n", file);
}

// ---- Text ---------------------------------------------------------------------------------------

static void print_text(FILE *file, double x, double y, SvgAnchor anchor, const char *look,
                       const char *format, va_list arguments)
{
    static const char *const ANCHORS[] = {"start", "middle", "end"};
    char text[256];
    vsnprintf(text, sizeof text, format, arguments);
    fprintf(file, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" %s>", x, y, ANCHORS[anchor],
            look);
    print_escaped(file, text);
    fputs("</text>\n", file);
}

void svg_text(FILE *file, double x, double y, SvgAnchor anchor, const char *look,
              const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_text(file, x, y, anchor, look, format, arguments);
    va_end(arguments);
}

void svg_title(FILE *file, double x, double y, SvgAnchor anchor, const char *look,
               const char *format, ...)
{
    char large[128];
    snprintf(large, sizeof large, "font-size=\"%d\" font-weight=\"bold\" %s", SVG_TITLE, look);
    va_list arguments;
    va_start(arguments, format);
    print_text(file, x, y, anchor, large, format, arguments);
    va_end(arguments);
}

double svg_text_width(const char *text)
{
    double n_characters = 0;
    for (; *text != '\0'; text++) {
        n_characters += !utf8_goes_on(*text);
    }
    return LETTER * SVG_TEXT * n_characters;
}

// ---- Shapes -------------------------------------------------------------------------------------

void svg_line(FILE *file, double x1, double y1, double x2, double y2, const char *look)
{
    fprintf(file, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" %s/>\n", x1, y1, x2, y2,
            look);
}

void svg_arrow(FILE *file, double x1, double y1, double x2, double y2, const char *look)
{
    char headed[160];
    snprintf(headed, sizeof headed, "stroke=\"" SVG_BLACK "\" marker-end=\"url(#head)\" %s", look);
    svg_line(file, x1, y1, x2, y2, headed);
}

void svg_box(FILE *file, double x, double y, double width, double height, const char *look)
{
    fprintf(file, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" %s/>\n", x, y, width,
            height, look);
}

void svg_circle(FILE *file, double x, double y, double radius, const char *look)
{
    fprintf(file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" %s/>\n", x, y, radius, look);
}

void svg_boxes_begin(FILE *file, const char *look)
{
    fprintf(file, "<path %s d=\"", look);
}

void svg_boxes_add(FILE *file, double x, double y, double width, double height)
{
    fprintf(file, "M%.1f %.1fh%.1fv%.1fh%.1fz", x, y, width, height, -width);
}

void svg_boxes_end(FILE *file)
{
    fputs("\"/>\n", file);
}

void svg_group_begin(FILE *file, const char *id, const char *look)
{
    fprintf(file, "<g id=\"%s\" %s>\n", id, look);
}

void svg_group_end(FILE *file)
{
    fputs("</g>\n", file);
}

void svg_use(FILE *file, const char *id, double x, double y)
{
    fprintf(file, "<use href=\"#%s\" x=\"%.1f\" y=\"%.1f\"/>\n", id, x, y);
}

void svg_cross(FILE *file, double x, double y, double half, const char *look)
{
    svg_line(file, x - half, y - half, x + half, y + half, look);
    svg_line(file, x - half, y + half, x + half, y - half, look);
}
