// pictures.json (see report.h): the wrong pictures, for programs.
//
// Read next: report_pictures.c.
#include "complain.h"
#include "json_text.h"
#include "message.h"
#include "report.h"
#include "report_pictures.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// An image, or in its place a drawing, as a data: URI. NULL after one message; free() it.
static char *uri_create(const Image *image, const char *svg)
{
    char *uri = NULL;
    size_t n_bytes = 0;
    FILE *stream = open_memstream(&uri, &n_bytes);
    int written = stream != NULL ? picture_uri_write(stream, image, svg) : -1;
    if (stream == NULL || fclose(stream) != 0) {
        complain("report: no memory for a picture");
        written = -1;
    }
    if (written != 0) {
        free(uri);
        return NULL;
    }
    return uri;
}

// Append {label, url} where there is such a picture. Returns 0, or -1 after one message.
static int figure_append(json_t *figures, const PictureResult *picture, const char *what,
                         const Image *image, const char *svg)
{
    if (image->width <= 0 && svg == NULL) {
        return 0;
    }
    char *uri = uri_create(image, svg);
    if (uri == NULL) {
        return -1;
    }
    char *label = message_new("%s (%s)", picture->title, what);
    json_t *figure = json_pack("{s:o, s:s}", "label", json_line(label), "url", uri);
    free(label);
    free(uri);
    if (json_array_append_new(figures, figure) != 0) {
        complain("report: no memory for a picture");
        return -1;
    }
    return 0;
}

// Append a wrong scene's picture, the reference and the difference: two of one size have one.
// Returns 0, or -1 after one message.
static int scene_append(json_t *figures, const PictureResult *picture)
{
    const Image *own = &picture->own;
    const Image *reference = &picture->reference;
    if (figure_append(figures, picture, "yours", own, picture->svg_own) != 0 ||
        figure_append(figures, picture, "as it should be", reference, picture->svg_reference) !=
            0) {
        return -1;
    }
    if (own->width <= 0 || own->width != reference->width || own->height != reference->height) {
        return 0;
    }
    Image difference = {0};
    int appended = image_difference_picture(own, reference, &difference);
    if (appended == 0) {
        appended = figure_append(
            figures, picture,
            "the difference: black where equal, pale yellow from 0.5 on, cyan where NaN",
            &difference, NULL);
    }
    image_free(&difference);
    return appended;
}

int report_pictures_json(const char *path, const Result *result)
{
    json_t *figures = json_array();
    for (int i = 0; i < result->n_pictures; i++) {
        const PictureResult *picture = &result->pictures[i];
        if (!scene_is_right(picture) && scene_append(figures, picture) != 0) {
            json_decref(figures);
            return -1;
        }
    }
    if (json_array_size(figures) > 0) {
        return json_save(path, figures, JSON_INDENT(2));
    }
    json_decref(figures);
    if (unlink(path) != 0 && errno != ENOENT) {
        complain("%s: older pictures cannot be removed: %s", path, strerror(errno));
        return -1;
    }
    return 0;
}
