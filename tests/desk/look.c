// Drawing the open scene (see look.h). Used by watch_round.c.
#include "look.h"

#include "message.h"
#include "path.h"
#include "stats.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Rounding may end otherwise on another device: half a step of a channel in a file, and this share
// of the pixels of a scene in 3D, where it decides what is seen.
#define TOLERANCE (1.5F / 255)
#define EXCEPTIONS_PER_PIXEL 0.002

void look_open(const Desk *desk, Look *look)
{
    char path[PATH_MAX];
    *look = (Look){.desk = desk};
    path_make(look->folder, "%s/watch", desk->build);
    path_make(look->picture, "%s/picture.png", look->folder);
    path_make(look->drawn, "%s/drawn.png", look->folder);
    mkdir(look->folder, 0777);
    if (desk->lab->figure == NULL || desk->options != NULL) {
        return;
    }
    path_make(path, "slides-notes/figures/%s", desk->lab->figure);
    if (access(path, R_OK) == 0 && image_load(path, &look->figure) == 0) {
        path_make(path, "%s/expected.png", look->folder);
        image_save(&look->figure, path);
    }
}

void look_close(Look *look)
{
    image_free(&look->figure);
}

const char *look_options(const Look *look)
{
    const Desk *desk = look->desk;
    return desk->options != NULL ? desk->options : desk->lab->look != NULL ? desk->lab->look : "";
}

int look_start_building(const Look *look, const char *const *changed, Child *child)
{
    enum { MOST_CHANGED = 32 };
    char program[PATH_MAX], newer[MOST_CHANGED][PATH_MAX];
    path_make(program, "%s/labs/%s", look->desk->build, look->desk->lab->lab);
    char *words[MOST_CHANGED + 5] = {(char *)look->desk->make, "-s", "--no-print-directory",
                                     program};
    for (int i = 0; i < MOST_CHANGED && changed != NULL && changed[i] != NULL; i++) {
        path_make(newer[i], "--what-if=labs/%s/%s", look->desk->lab->lab, changed[i]);
        words[4 + i] = newer[i];
    }
    return child_start(child, words, CHILD_IS_READ);
}

int look_start_drawing(const Look *look, Child *child)
{
    enum { MOST_OPTIONS = 32 };
    char program[PATH_MAX];
    path_make(program, "%s/labs/%s", look->desk->build, look->desk->lab->lab);
    char *words[MOST_OPTIONS + 6] = {program};
    char *options = strdup(look_options(look)), *rest = NULL;
    int n = 1;
    for (char *word = strtok_r(options, " ", &rest); word != NULL && n < MOST_OPTIONS;
         word = strtok_r(NULL, " ", &rest)) {
        words[n++] = word;
    }
    words[n++] = "--output";
    words[n++] = (char *)look->drawn;
    if (look->desk->device != NULL) {
        words[n++] = "--device";
        words[n++] = (char *)look->desk->device;
    }
    unlink(look->drawn);
    const int started = child_start(child, words, CHILD_IS_READ);
    free(options);
    return started;
}

#define TEXT(number) #number
#define TEXT_OF(number) TEXT(number)

const char *look_is_late(const Child *child)
{
    return child_seconds(child) > LOOK_MOST_SECONDS
               ? "drawing had no end in " TEXT_OF(
                     LOOK_MOST_SECONDS) " s of processor time: does a loop never end?"
           : stats_clock_ms() - child->start_ms > 1000.0 * LOOK_MOST_WAIT_SECONDS
               ? "drawing had not ended after " TEXT_OF(LOOK_MOST_WAIT_SECONDS) " s"
               : NULL;
}

void look_compare(Look *look)
{
    char path[PATH_MAX];
    Image own = {0}, difference = {0};
    look->is_older = access(look->drawn, R_OK) != 0 || image_load(look->drawn, &own) != 0 ||
                     rename(look->drawn, look->picture) != 0;
    if (!look->is_older) {
        look->has_picture = 1;
        look->is_compared = 0;
    }
    if (!look->is_older && look->figure.pixels != NULL) {
        ImageDifference *found = &look->difference;
        *found = image_compare(&own, &look->figure, TOLERANCE);
        if (found->n_different <= EXCEPTIONS_PER_PIXEL * own.width * own.height) {
            found->n_different = 0;
        }
        path_make(path, "%s/difference.png", look->folder);
        look->is_compared = found->same_size &&
                            image_difference_picture(&own, &look->figure, &difference) == 0 &&
                            image_save(&difference, path) == 0;
    }
    image_free(&own);
    image_free(&difference);
}

int look_can_be_followed(const Desk *desk)
{
    char steps[PATH_MAX];
    path_make(steps, "common/follow/steps/%s.cl", desk->lab->lab);
    return access(steps, R_OK) == 0;
}

char *look_command(const Look *look)
{
    const char *lab = look->desk->lab->lab;
    if (look->is_older || !look->is_compared || look->difference.n_different == 0 ||
        !look_can_be_followed(look->desk)) {
        return NULL;
    }
    return message_new("make pixel LAB=%.2s AT=%d,%d OPTIONS=\"%s\"", lab, look->difference.first_x,
                       look->difference.first_y, look_options(look));
}
