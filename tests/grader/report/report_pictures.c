// The pictures of an HTML report (see report_pictures.h).
//
// Pixels go in as PNG; drawings (<svg>) go in as images, in which no script can run.
#include "report_pictures.h"

#include "html.h"
#include "image.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Below this width a picture is shown magnified on any screen: its pixels shall stay squares.
#define SMALL_WIDTH 360

int picture_uri_write(FILE *page, const Image *image, const char *svg)
{
    unsigned char *bytes;
    size_t n_bytes;
    if (svg != NULL) {
        html_file_uri(page, "image/svg+xml", svg, strlen(svg));
        return 0;
    }
    if (image_encode(image, "png", "a picture of the report", &bytes, &n_bytes) != 0) {
        return -1;
    }
    html_file_uri(page, "image/png", bytes, n_bytes);
    free(bytes);
    return 0;
}

int scene_is_right(const PictureResult *picture)
{
    if (picture->own.width <= 0 || picture->reference.width <= 0) {
        return 0;
    }
    const ImageDifference difference = image_compare(&picture->own, &picture->reference, 0);
    return difference.same_size && difference.n_different == 0;
}

// What the colours of the difference mean: the colours themselves, and numbers below them.
static void legend_write(FILE *page)
{
    enum { N_COLOURS = 17, N_NUMBERS = 5 };
    fputs("<div class=\"legend\"><div class=\"colours\" role=\"img\" aria-label=\"from black over "
          "purple, red and orange to pale yellow\" style=\"background: linear-gradient(to right",
          page);
    for (int i = 0; i < N_COLOURS; i++) {
        float rgb[3];
        image_heat_colour((float)i / (N_COLOURS - 1), rgb);
        fprintf(page, ", #%02x%02x%02x", (unsigned)lrintf(255 * rgb[0]),
                (unsigned)lrintf(255 * rgb[1]), (unsigned)lrintf(255 * rgb[2]));
    }
    fputs(")\"></div><div class=\"numbers number\">", page);
    for (int i = 0; i < N_NUMBERS; i++) {
        fprintf(page, "<span>%s%g</span>", i == N_NUMBERS - 1 ? "&ge; " : "",
                (double)IMAGE_BRIGHTEST_DIFFERENCE * i / (N_NUMBERS - 1));
    }
    fputs("</div><p>the differences of red, green, blue and alpha, added up; black is equal, and "
          "what is no number (NaN) is cyan</p></div>",
          page);
}

// The figures of a scene: the words around each, and in the place of one that is not there.
typedef enum FigureKind { FIGURE_REFERENCE, FIGURE_OWN, FIGURE_DIFFERENCE } FigureKind;
static const struct {
    const char *class, *caption, *alt, *missing;
} figures[] = {
    [FIGURE_REFERENCE] = {"reference", "Reference", "the reference", "no reference"},
    [FIGURE_OWN] = {"own", "Yours", "your picture", "there is none"},
    [FIGURE_DIFFERENCE] = {"difference", "Difference", "the difference", "needs both pictures"},
};

static void figure_begin(FILE *page, FigureKind kind, const char *attributes, const char *note)
{
    fprintf(page, "<figure class=\"%s\"%s>", figures[kind].class, attributes);
    html_write(page, "<figcaption>%s <span>%s</span></figcaption>\n", figures[kind].caption, note);
}

// What it shows: the drawing, where there is one, else the image. Returns 0, or -1 after one
// message.
static int figure_show(FILE *page, FigureKind kind, const Image *image, const char *svg)
{
    if (svg == NULL && image->width <= 0) {
        html_write(page, "<div class=\"missing\">%s</div>", figures[kind].missing);
        return 0;
    }
    html_write(page, "<img alt=\"%s\"", figures[kind].alt);
    if (svg != NULL) {
        fputs(" class=\"drawing\"", page);
    } else {
        fprintf(page, " width=\"%d\" height=\"%d\"%s", image->width, image->height,
                image->width < SMALL_WIDTH ? " class=\"small\"" : "");
    }
    fputs(" src=\"", page);
    const int written = picture_uri_write(page, image, svg);
    fputs("\">", page);
    return written;
}

static int reference_write(FILE *page, const PictureResult *picture)
{
    figure_begin(page, FIGURE_REFERENCE, "", "as it should be");
    const int written =
        figure_show(page, FIGURE_REFERENCE, &picture->reference, picture->svg_reference);
    fputs("</figure>\n", page);
    return written;
}

static int own_write(FILE *page, const PictureResult *picture, int is_right)
{
    const int is_there = picture->svg_own != NULL || picture->own.width > 0;
    const int flips = is_there && !is_right;
    // In the order of the tab key, so that flipping to the reference needs no mouse.
    figure_begin(page, FIGURE_OWN, flips ? " tabindex=\"0\"" : "",
                 is_right ? "equal to the reference"
                 : flips  ? "point at it to see the reference"
                          : "");
    const int written = figure_show(page, FIGURE_OWN, &picture->own, picture->svg_own);
    fputs("</figure>\n", page);
    return written;
}

static int difference_write(FILE *page, const PictureResult *picture)
{
    const Image *own = &picture->own, *reference = &picture->reference;
    const int are_there = own->width > 0 && reference->width > 0;
    Image difference = {0};
    int written = 0;
    figure_begin(page, FIGURE_DIFFERENCE, "", "black where equal");
    if (are_there && (own->width != reference->width || own->height != reference->height)) {
        fprintf(page,
                "<div class=\"missing\">the sizes differ: the reference is %d&times;%d, "
                "yours %d&times;%d</div>",
                reference->width, reference->height, own->width, own->height);
    } else {
        written = are_there ? image_difference_picture(own, reference, &difference) : 0;
        written = written == 0 ? figure_show(page, FIGURE_DIFFERENCE, &difference, NULL) : -1;
    }
    if (difference.width > 0) {
        legend_write(page);
    }
    image_free(&difference);
    fputs("</figure>\n", page);
    return written;
}

int report_pictures_write(FILE *page, const PictureResult *picture)
{
    // Drawings have no pixels to subtract.
    const int are_drawings = picture->svg_reference != NULL || picture->svg_own != NULL;
    const int is_right = scene_is_right(picture);  // then one picture says it all
    html_write(page, "<article class=\"card\">\n<div class=\"title\"><h3>%s</h3></div>\n",
               picture->title);
    fprintf(page, "<div class=\"trio%s\">\n", are_drawings ? " pair" : "");
    const int failed = (!is_right && reference_write(page, picture) != 0) ||
                       own_write(page, picture, is_right) != 0 ||
                       (!is_right && !are_drawings && difference_write(page, picture) != 0);
    fputs("</div>\n</article>\n", page);
    return failed ? -1 : 0;
}
