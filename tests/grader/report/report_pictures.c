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

int picture_uri_write(FILE *page, const Image *image)
{
    unsigned char *bytes;
    size_t n_bytes;
    if (image_encode(image, "png", "a picture of the report", &bytes, &n_bytes) != 0) {
        return -1;
    }
    html_file_uri(page, "image/png", bytes, n_bytes);
    free(bytes);
    return 0;
}

static int image_figure_write(FILE *page, const Image *image, const char *alt)
{
    fprintf(page, "<img alt=\"%s\" width=\"%d\" height=\"%d\"%s src=\"", alt, image->width,
            image->height, image->width < SMALL_WIDTH ? " class=\"small\"" : "");
    int written = picture_uri_write(page, image);
    fputs("\">", page);
    return written;
}

static void drawing_figure_write(FILE *page, const char *svg, const char *alt)
{
    fprintf(page, "<img alt=\"%s\" class=\"drawing\" src=\"", alt);
    html_file_uri(page, "image/svg+xml", svg, strlen(svg));
    fputs("\">", page);
}

static void figure_begin(FILE *page, const char *attributes, const char *caption, const char *note)
{
    fprintf(page, "<figure %s><figcaption>%s <span>%s</span></figcaption>\n", attributes, caption,
            note);
}

static int reference_write(FILE *page, const PictureResult *picture)
{
    int written = 0;
    figure_begin(page, "class=\"reference\"", "Reference", "as it should be");
    if (picture->svg_reference != NULL) {
        drawing_figure_write(page, picture->svg_reference, "the reference");
    } else if (picture->reference.width > 0) {
        written = image_figure_write(page, &picture->reference, "the reference");
    } else {
        fputs("<div class=\"missing\">no reference</div>", page);
    }
    fputs("</figure>\n", page);
    return written;
}

int scene_is_right(const PictureResult *picture)
{
    if (picture->own.width <= 0 || picture->reference.width <= 0) {
        return 0;
    }
    const ImageDifference difference = image_compare(&picture->own, &picture->reference, 0);
    return difference.same_size && difference.n_different == 0;
}

static int right_write(FILE *page, const PictureResult *picture)
{
    figure_begin(page, "class=\"own\"", "Yours", "equal to the reference");
    const int written = image_figure_write(page, &picture->own, "your picture");
    fputs("</figure>\n", page);
    return written;
}

static int own_write(FILE *page, const PictureResult *picture)
{
    int written = 0;
    if (picture->svg_own == NULL && picture->own.width <= 0) {
        figure_begin(page, "class=\"own\"", "Yours", "");
        fputs("<div class=\"missing\">there is none</div></figure>\n", page);
        return 0;
    }
    // In the order of the tab key, so that flipping to the reference needs no mouse.
    figure_begin(page, "class=\"own\" tabindex=\"0\"", "Yours", "point at it to see the reference");
    if (picture->svg_own != NULL) {
        drawing_figure_write(page, picture->svg_own, "your picture");
    } else {
        written = image_figure_write(page, &picture->own, "your picture");
    }
    fputs("</figure>\n", page);
    return written;
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

static int difference_write(FILE *page, const PictureResult *picture)
{
    const Image *own = &picture->own;
    const Image *reference = &picture->reference;
    int written = 0;
    figure_begin(page, "class=\"difference\"", "Difference", "black where equal");
    if (own->width <= 0 || reference->width <= 0) {
        fputs("<div class=\"missing\">needs both pictures</div>", page);
    } else if (own->width != reference->width || own->height != reference->height) {
        fprintf(page,
                "<div class=\"missing\">the sizes differ: the reference is %d&times;%d, "
                "yours %d&times;%d</div>",
                reference->width, reference->height, own->width, own->height);
    } else {
        Image difference = {0};
        written = image_difference_picture(own, reference, &difference);
        if (written == 0) {
            written = image_figure_write(page, &difference, "the difference");
            legend_write(page);
        }
        image_free(&difference);
    }
    fputs("</figure>\n", page);
    return written;
}

int report_pictures_write(FILE *page, const PictureResult *picture)
{
    // Drawings have no pixels to subtract.
    int drawings = picture->svg_reference != NULL || picture->svg_own != NULL;
    fputs("<article class=\"card\">\n<div class=\"title\"><h3>", page);
    html_line(page, picture->title);
    fprintf(page, "</h3></div>\n<div class=\"trio%s\">\n", drawings ? " pair" : "");
    int written;
    if (scene_is_right(picture)) {  // one says it all
        written = right_write(page, picture);
    } else {
        written = reference_write(page, picture);
        if (written == 0) {
            written = own_write(page, picture);
        }
        if (written == 0 && !drawings) {
            written = difference_write(page, picture);
        }
    }
    fputs("</div>\n</article>\n", page);
    return written;
}
