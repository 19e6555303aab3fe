// A result's pictures for documents in JSON (see json_pictures.h).
//
// Flow: judging -> result -> REPORTS. Read next: report_prairielearn.c.
#include "json_pictures.h"

#include "html.h"
#include "message.h"
#include "report_pictures.h"

#include <stdlib.h>
#include <string.h>

// A list that may still grow.
typedef struct PictureList {
    json_t *list;
    size_t bytes_left;
} PictureList;

// Append {label, url} where it fits. Returns 0, or -1 after one message.
static int figure_append(PictureList *pictures, const PictureResult *picture, const char *what,
                         const char *url)
{
    char *label = message_new("%s (%s)", picture->title, what);
    json_t *figure = json_pack("{s:o, s:s}", "label", json_line(label), "url", url);
    free(label);
    if (figure == NULL) {
        fprintf(stderr, "report: no memory for a picture\n");
        return -1;
    }
    const size_t n_bytes = json_dumpb(figure, NULL, 0, JSON_COMPACT) + strlen(",");
    if (n_bytes > pictures->bytes_left) {
        json_decref(figure);
        return 0;
    }
    pictures->bytes_left -= n_bytes;
    return json_array_append_new(pictures->list, figure);
}

// One image, or in its place a drawing; neither is fine. Returns 0, or -1 after one message.
static int image_append(PictureList *pictures, const PictureResult *picture, const char *what,
                        const Image *image, const char *svg)
{
    if (image->width <= 0 && svg == NULL) {
        return 0;
    }
    char *url = NULL;
    size_t n_bytes = 0;
    FILE *stream = open_memstream(&url, &n_bytes);
    if (stream == NULL) {
        fprintf(stderr, "report: no memory for a picture\n");
        return -1;
    }
    int written = 0;
    if (svg != NULL) {
        html_file_uri(stream, "image/svg+xml", svg, strlen(svg));
    } else {
        written = picture_uri_write(stream, image);
    }
    if (fclose(stream) != 0) {
        fprintf(stderr, "report: no memory for a picture\n");
        written = -1;
    }
    written = written == 0 ? figure_append(pictures, picture, what, url) : -1;
    free(url);
    return written;
}

static int difference_append(PictureList *pictures, const PictureResult *picture)
{
    Image difference = {0};
    int written = image_difference_picture(&picture->own, &picture->reference, &difference);
    if (written == 0) {
        written = image_append(
            pictures, picture,
            "the difference: black where equal, pale yellow from 0.5 on, cyan where NaN",
            &difference, NULL);
    }
    image_free(&difference);
    return written;
}

static int scene_append(PictureList *pictures, const PictureResult *picture)
{
    const Image *own = &picture->own;
    const Image *reference = &picture->reference;
    ImageDifference compared = {0};
    if (own->width > 0 && reference->width > 0) {
        compared = image_compare(own, reference, 0);
    }
    if (compared.same_size && compared.n_different == 0) {
        return 0;
    }
    int written = image_append(pictures, picture, "yours", own, picture->svg_own);
    if (written == 0) {
        written =
            image_append(pictures, picture, "as it should be", reference, picture->svg_reference);
    }
    if (written == 0 && compared.same_size) {
        written = difference_append(pictures, picture);
    }
    return written;
}

json_t *json_pictures(const Result *result, size_t max_bytes)
{
    PictureList pictures = {json_array(), max_bytes};
    int written = pictures.list != NULL ? 0 : -1;
    for (int i = 0; i < result->n_pictures && written == 0; i++) {
        written = scene_append(&pictures, &result->pictures[i]);
    }
    if (written != 0) {
        json_decref(pictures.list);
        return NULL;
    }
    return pictures.list;
}
