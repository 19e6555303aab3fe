// Lab 10's kernels without one of their tricks (see trick.h).
//
// Read next: bench_tricks.c.
#include "trick.h"

#include "complain.h"
#include "output_file.h"
#include "path.h"
#include "text_file.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define LAB "solutions/10-realtime"

#define CIRCLES_FILE "render_circles.cl"

// In the place of save_tile(): each pixel by a call of its own, into an image of floats.
static const char SAVE_FLOATS[] =
    "static void save_floats(const CircleTile *tile, write_only image2d_t image)\n"
    "{\n"
    "    for (int row = 0; row < N_ROWS; row++) {\n"
    "        uint colors[LANES];\n"
    "        JOIN(vstore, LANES)(tile->colors[row], 0, colors);\n"
    "        for (int lane = 0; lane < LANES; lane++) {\n"
    "            write_imagef(image, (int2)(tile->x + lane, tile->y + row),\n"
    "                         convert_float4(as_uchar4(colors[lane])) / 255.0f);\n"
    "        }\n"
    "    }\n"
    "}\n\n"
    "// Write down what a tile cost";

static const Trick CIRCLE_TRICKS[] = {
    {.name = "circles", .title = "with all tricks"},
    {.name = "one-row",
     .title = "a descent for each row of a tile",
     .changes = {{CIRCLES_FILE, "#define N_ROWS LANES", "#define N_ROWS 1"}},
     .height = 1},
    {.name = "8-lanes",
     .title = "8 pixels in a vector, tiles of 8 x 8",
     .width = 8,
     .height = 8,
     .lanes = 8},
    {.name = "4-lanes",
     .title = "4 pixels in a vector, tiles of 4 x 4",
     .width = 4,
     .height = 4,
     .lanes = 4},
    {.name = "no-early-end",
     .title = "to the end of the list, though all is covered",
     .changes = {{CIRCLES_FILE, "i % CIRCLES_A_LOOK == 0 && !is_open(tile)",
                  "i > leaf.n_circles && !is_open(tile)"}}},
    {.name = "hidden-circles", .title = "hidden circles are in the lists", .has_hidden_circles = 1},
    {.name = "image",
     .title = "an image of floats in the place of bytes",
     .changes = {{CIRCLES_FILE, "// Write down what a tile cost", SAVE_FLOATS},
                 {CIRCLES_FILE, "int width, int height, global uint *pixels, global Work *d_work)",
                  "int width, int height, write_only image2d_t image, global Work *d_work)"},
                 {CIRCLES_FILE, "    save_tile(&tile, width, height, pixels);",
                  "    save_floats(&tile, image);"}},
     .has_image = 1},
};

static const Trick SPHERE_TRICKS[] = {
    {.name = "spheres", .title = "with all tricks"},
    {.name = "small-tiles", .title = "tiles of 4 x 4 rays", .width = 4, .height = 4},
    {.name = "large-tiles", .title = "tiles of 16 x 16 rays", .width = 16, .height = 16},
    {.name = "8-rays",
     .title = "8 rays in a vector, tiles of 8 x 8",
     .width = 8,
     .height = 8,
     .lanes = 8},
    {.name = "no-cone",
     .title = "all spheres of a leaf are asked, no cone",
     .changes = {{"cone.cl", "return aside * cone.cosine - along * cone.sine > fabs(radius);",
                  "return 0;"}}},
    {.name = "scene-order",
     .title = "a leaf's spheres are looked up by their ids",
     .changes = {{"trace_tile.cl", "= leaf_spheres[i];", "= leaf_spheres[sphere_ids[i]];"}},
     .in_scene_order = 1},
    {.name = "small-leaves",
     .title = "a tree with leaves as small as lab 08's",
     .has_small_leaves = 1},
    {.name = "no-hits",
     .title = "nodes that begin behind all hits are visited",
     .changes = {{"trace_tile.cl", "next_tile_waiting(farthest_hit(hits), &todo, &at)",
                  "next_tile_waiting(INFINITY, &todo, &at)"}}},
    {.name = "branch",
     .title = "one more: a vector whose rays all miss ends early",
     .changes = {{"trace_tile.cl", "    const Lanes half_chord = sqrt(disc);",
                  "    if (!any(disc >= 0.0f)) {\n"
                  "        return;\n"
                  "    }\n"
                  "    const Lanes half_chord = sqrt(disc);"}}},
};

#define N_OF(array) ((int)(sizeof(array) / sizeof *(array)))

const PartTricks PART_TRICKS[N_PARTS] = {
    [CIRCLES] = {CIRCLES_FILE, "render_circles", CIRCLE_TRICKS, N_OF(CIRCLE_TRICKS)},
    [SPHERES] = {"render_tiles.cl", "render_tiles", SPHERE_TRICKS, N_OF(SPHERE_TRICKS)},
};

TileShape trick_shape(const Trick *trick, TileShape usual)
{
    TileShape shape = usual;
    shape.width = trick->width > 0 ? trick->width : usual.width;
    shape.height = trick->height > 0 ? trick->height : usual.height;
    shape.lanes = trick->lanes > 0 ? trick->lanes : usual.lanes;
    // One large tile keeps a work-group's memory busy: see tile_shape().
    const int is_larger = shape.width * shape.height > usual.width * usual.height;
    shape.group_side = is_larger ? 1 : usual.group_side;
    return shape;
}

// ---- Texts --------------------------------------------------------------------------------------

// Change a text. Takes it over. Returns the new one, free() it, or NULL after one message.
static char *change_text(char *text, const TextChange *change)
{
    const char *at = strstr(text, change->from);
    if (at == NULL || strstr(at + 1, change->from) != NULL) {
        complain("bench_tricks: %s/%s: found \"%s\" %s, expected it once", LAB, change->file,
                 change->from, at == NULL ? "nowhere" : "twice");
        free(text);
        return NULL;
    }
    const char *rest = at + strlen(change->from);
    const size_t n_bytes = strlen(text) + strlen(change->to) + 1;
    char *changed = malloc(n_bytes);
    if (changed != NULL) {
        snprintf(changed, n_bytes, "%.*s%s%s", (int)(at - text), text, change->to, rest);
    } else {
        complain("bench_tricks: no memory for a kernel");
    }
    free(text);
    return changed;
}

// Copy one of the lab's files, changed. Returns 0, or -1 after one message.
static int copy_changed(const char *file, const Trick *trick, const char *folder)
{
    char path[PATH_MAX];
    path_make(path, LAB "/%s", file);
    char *text = text_file_read(path);
    for (int i = 0; text != NULL && i < MAX_CHANGES; i++) {
        const TextChange *change = &trick->changes[i];
        if (change->file != NULL && strcmp(change->file, file) == 0) {
            text = change_text(text, change);
        }
    }
    OutputFile output;
    path_make(path, "%s/%s", folder, file);
    if (text == NULL || output_file_open(&output, path) != 0) {
        free(text);
        return -1;
    }
    fputs(text, output.file);
    free(text);
    return output_file_commit(&output);
}

// What a device compiles: all of it is copied, as a file looks for others in its own folder first.
static int is_for_device(const struct dirent *entry)
{
    const char *ending = strrchr(entry->d_name, '.');
    return ending != NULL && (strcmp(ending, ".cl") == 0 || strcmp(ending, ".h") == 0);
}

int trick_write(const Trick *trick, const char *folder)
{
    struct dirent **entries = NULL;
    const int n_entries = scandir(LAB, &entries, is_for_device, alphasort);
    int result = n_entries >= 0 ? 0 : -1;
    if (result != 0) {
        complain("bench_tricks: %s: cannot be read: %s", LAB, strerror(errno));
    } else if (mkdir(folder, 0777) != 0 && errno != EEXIST) {
        complain("bench_tricks: cannot make the folder %s: %s", folder, strerror(errno));
        result = -1;
    }
    for (int i = 0; i < n_entries; i++) {
        result = result == 0 ? copy_changed(entries[i]->d_name, trick, folder) : -1;
        free(entries[i]);
    }
    free(entries);
    return result;
}
