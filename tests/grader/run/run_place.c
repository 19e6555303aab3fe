// The steps of each lab's probe, and what they are called with, in words (see run_place.h).
#include "run_place.h"

#include "jobs_08.h"
#include "jobs_09.h"
#include "jobs_10.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// ---- Inputs of host functions, in the words of the judges ---------------------------------------

typedef void Describe(const void *input, char *words, size_t n_bytes);

static void describe_leaf(const void *input, char *words, size_t n_bytes)
{
    const LeafJob *in = input;
    snprintf(words, n_bytes,
             "level %d, %u circles, %d failed splits, maxDepth %d, targetElementsPerNode %d",
             in->level, in->n_circles, in->n_failed, in->maxDepth, in->targetElementsPerNode);
}

static void describe_box(const void *input, char *words, size_t n_bytes)
{
    const BBox2D *box = input;
    snprintf(words, n_bytes, "box x [%g, %g] y [%g, %g]", (double)box->minX, (double)box->maxX,
             (double)box->minY, (double)box->maxY);
}

static void describe_circle_and_box(const void *input, char *words, size_t n_bytes)
{
    const BoxOverlapJob *in = input;
    char box[80];
    describe_box(&in->box, box, sizeof box);
    snprintf(words, n_bytes, "circle at (%g, %g) radius %g, %s", (double)in->circle.x,
             (double)in->circle.y, (double)in->circle.radius, box);
}

static void describe_distribute(const void *input, char *words, size_t n_bytes)
{
    const DistributeJob *in = input;
    snprintf(words, n_bytes, "node with %u circles", in->n_ids);
}

static void describe_pack(const void *input, char *words, size_t n_bytes)
{
    const PackJob *in = input;
    snprintf(words, n_bytes, "leaf with %u circles, map of %u entries", in->n_ids, in->n_before);
}

static void describe_view(const void *input, char *words, size_t n_bytes)
{
    const ViewJob *in = input;
    snprintf(words, n_bytes, "from (%g, %g, %g) at (%g, %g, %g) up (%g, %g, %g)",
             (double)in->from.x, (double)in->from.y, (double)in->from.z, (double)in->at.x,
             (double)in->at.y, (double)in->at.z, (double)in->up.x, (double)in->up.y,
             (double)in->up.z);
}

static void describe_box3(const void *input, char *words, size_t n_bytes)
{
    const BBox3D *box = input;
    snprintf(words, n_bytes, "box x [%g, %g] y [%g, %g] z [%g, %g]", (double)box->min[0],
             (double)box->max[0], (double)box->min[1], (double)box->max[1], (double)box->min[2],
             (double)box->max[2]);
}

static void describe_sphere_and_box(const void *input, char *words, size_t n_bytes)
{
    const SphereBoxJob *in = input;
    char box[100];
    describe_box3(&in->box, box, sizeof box);
    snprintf(words, n_bytes, "sphere at (%g, %g, %g) radius %g, %s", (double)in->sphere.x,
             (double)in->sphere.y, (double)in->sphere.z, (double)in->sphere.radius, box);
}

static void describe_pack3(const void *input, char *words, size_t n_bytes)
{
    const PackJob *in = input;
    snprintf(words, n_bytes, "leaf with %u spheres, %u ids before it", in->n_ids, in->n_before);
}

// ---- The steps ----------------------------------------------------------------------------------

typedef enum StepKind {
    ON_NOTHING,
    ON_INPUTS,  // of the section of the step's name, one call each: on the host one after the
                // other, on the device all together
    ON_SCENE,   // with a title
    ON_LEVEL,   // a number from 1 to TODO_LEVELS
} StepKind;

typedef struct ProbeStep {
    const char *lab;   // its number; "" for all
    const char *name;  // as noted
    const char *where;
    const char *task;  // where one task is all that runs
    StepKind kind;
    size_t input_bytes;
    Describe *describe;  // for host functions
} ProbeStep;

static const ProbeStep steps[] = {
    {.lab = "", .name = "", .where = "before any of your functions was called"},
    {.lab = "", .name = "build", .where = "while your kernels were compiled"},
    {"00", "picture", "in the kernel gradient", "gradient", ON_SCENE, 0, NULL},
    {"00", "arguments", "in set_arguments", "set_arguments", ON_SCENE, 0, NULL},
    {"00", "items", "in enqueue_pixels", "enqueue_pixels", ON_SCENE, 0, NULL},
    {"00", "readback", "in read_back", "read_back", ON_SCENE, 0, NULL},
    {"01", "overlaps", "in overlaps_N_Nearer", "overlaps_N_Nearer", ON_INPUTS, sizeof(OverlapJob),
     NULL},
    {"01", "picture", "in implicit2DRenderer", NULL, ON_SCENE, 0, NULL},
    {"02", "leaves", "in is_leaf", "is_leaf", ON_INPUTS, sizeof(LeafJob), describe_leaf},
    {"02", "splits", "in split_box", "split_box", ON_INPUTS, sizeof(BBox2D), describe_box},
    {"02", "overlaps", "in circle_overlaps_box", "circle_overlaps_box", ON_INPUTS,
     sizeof(BoxOverlapJob), describe_circle_and_box},
    {"02", "distribute", "in distribute", "distribute", ON_INPUTS, sizeof(DistributeJob),
     describe_distribute},
    {"02", "pack", "in pack_leaf", "pack_leaf", ON_INPUTS, sizeof(PackJob), describe_pack},
    {"02", "tree", "while kdtree2d_build built a whole tree", NULL, ON_SCENE, 0, NULL},
    {"03", "children", "in getContainingChild", "getContainingChild", ON_INPUTS, sizeof(ChildJob),
     NULL},
    {"03", "picture", "in implicit2DRenderer_KD", NULL, ON_SCENE, 0, NULL},
    {"04", "views", "in camera_axes", "camera_axes", ON_INPUTS, sizeof(ViewJob), describe_view},
    {"04", "pixels", "in pixel_on_display or primary_ray", NULL, ON_INPUTS, sizeof(PixelJob), NULL},
    {"04", "picture", "in draw_directions", NULL, ON_SCENE, 0, NULL},
    {"05", "roots", "in nearest_root", "nearest_root", ON_INPUTS, sizeof(RootJob), NULL},
    {"05", "textbook", "in intersect_textbook", "intersect_textbook", ON_INPUTS,
     sizeof(SphereRayJob), NULL},
    {"05", "projection", "in intersect_sphere", "intersect_sphere", ON_INPUTS, sizeof(SphereRayJob),
     NULL},
    {"05", "normals", "in surface_normal", "surface_normal", ON_INPUTS, sizeof(NormalJob), NULL},
    {"05", "shades", "in shade", "shade", ON_INPUTS, sizeof(ShadeJob), NULL},
    {"05", "hits", "in nearest_hit", "nearest_hit", ON_SCENE, 0, NULL},
    {"05", "picture", "in render_spheres", NULL, ON_SCENE, 0, NULL},
    {"06", "splits", "in choose_split", "choose_split", ON_INPUTS, sizeof(BBox3D), describe_box3},
    {"06", "overlaps", "in sphere_overlaps_box", "sphere_overlaps_box", ON_INPUTS,
     sizeof(SphereBoxJob), describe_sphere_and_box},
    {"06", "pack", "in pack_leaf_range", "pack_leaf_range", ON_INPUTS, sizeof(PackJob),
     describe_pack3},
    {"06", "todo", "in fits_todo", "fits_todo", ON_LEVEL, 0, NULL},
    {"06", "tree", "while kdtree3d_build built a whole tree", NULL, ON_SCENE, 0, NULL},
    {"07", "clips", "in clip_to_box", "clip_to_box", ON_INPUTS, sizeof(ClipJob), NULL},
    {"07", "sides", "in near_side", "near_side", ON_INPUTS, sizeof(SideJob), NULL},
    {"07", "planes", "in children_on_ray", "children_on_ray", ON_INPUTS, sizeof(PlaneJob), NULL},
    {"07", "leaves", "in search_leaf", "search_leaf", ON_INPUTS, sizeof(SearchJob), NULL},
    {"07", "next_child", "in next_child", "next_child", ON_INPUTS, sizeof(NextChildJob), NULL},
    {"07", "next_waiting", "in next_waiting", "next_waiting", ON_INPUTS, sizeof(NextWaitingJob),
     NULL},
    {"07", "hits", "in trace", NULL, ON_SCENE, 0, NULL},
    {"07", "picture", "in render_kdtree", NULL, ON_SCENE, 0, NULL},
    {"08", "areas", "in surface_area", "surface_area", ON_INPUTS, sizeof(BBox3D), describe_box3},
    {"08", "costs", "in split_cost", "split_cost", ON_INPUTS, sizeof(CostJob), NULL},
    {"08", "bests", "in find_best_split", "find_best_split", ON_INPUTS, sizeof(BestJob), NULL},
    {"08", "decisions", "in is_leaf_by_cost", "is_leaf_by_cost", ON_INPUTS, sizeof(LeafCostJob),
     NULL},
    {"08", "tree", "while kdtree3d_build_sah built a whole tree", NULL, ON_SCENE, 0, NULL},
    {"09", "starts", "in leave_surface", "leave_surface", ON_INPUTS, sizeof(StartJob), NULL},
    {"09", "mirrors", "in mirrored_direction", "mirrored_direction", ON_INPUTS, sizeof(MirrorJob),
     NULL},
    {"09", "shadow_rays", "in shadow_ray", "shadow_ray", ON_INPUTS, sizeof(ShadowRayJob), NULL},
    {"09", "blocks", "in leaf_blocks", "leaf_blocks", ON_INPUTS, sizeof(BlockJob), NULL},
    {"09", "lits", "in lit_color", "lit_color", ON_INPUTS, sizeof(LitJob), NULL},
    {"09", "picture", "in render_mirrors", NULL, ON_SCENE, 0, NULL},
    {"10", "tile_planes", "in plane_interval", "plane_interval", ON_INPUTS, sizeof(TilePlaneJob),
     NULL},
    {"10", "tile_children", "in next_tile_child", "next_tile_child", ON_INPUTS,
     sizeof(TileChildJob), NULL},
    {"10", "tile_waiting", "in next_tile_waiting", "next_tile_waiting", ON_INPUTS,
     sizeof(TileWaitingJob), NULL},
    {"10", "cones", "in cone_misses_sphere", "cone_misses_sphere", ON_INPUTS, sizeof(ConeJob),
     NULL},
    {"10", "circle_rows", "in paint_row", "paint_row", ON_INPUTS, sizeof(CircleRowJob), NULL},
    {"10", "tile_leaves", "in tile_leaf", "tile_leaf", ON_INPUTS, sizeof(CircleTileJob), NULL},
    {"10", "circle_tiles", "in tile_leaf or paint_row", NULL, ON_INPUTS, sizeof(CircleTileJob),
     NULL},
    {"10", "picture", "in trace_tile", NULL, ON_SCENE, 0, NULL},
};

// The step of a note, or NULL. Names are compared with their padding: one without an end is none.
static const ProbeStep *step_find(const char *lab, const ProbeNote *note)
{
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        char name[SECTION_NAME_BYTES] = {0};
        memcpy(name, steps[i].name, strlen(steps[i].name));
        if (strncmp(steps[i].lab, lab, strlen(steps[i].lab)) == 0 &&
            memcmp(name, note->name, sizeof name) == 0) {
            return &steps[i];
        }
    }
    return NULL;
}

static void describe_inputs(const ProbeStep *step, const Sections *job, uint32_t number,
                            RunPlace *place)
{
    size_t n_bytes;
    const unsigned char *inputs = sections_find_any(job, step->name, &n_bytes);
    const size_t n = inputs != NULL ? n_bytes / step->input_bytes : 0;
    if (step->describe != NULL && number < n) {
        char input[sizeof place->with - 40];
        step->describe(inputs + number * step->input_bytes, input, sizeof input);
        snprintf(place->with, sizeof place->with, "input %u of %zu: %s", number + 1, n, input);
    } else if (step->describe == NULL && n > 0) {
        snprintf(place->with, sizeof place->with, "with one of %zu inputs", n);
    }
}

static void describe_scene(const Sections *job, uint32_t number, RunPlace *place)
{
    char name[SECTION_NAME_BYTES];
    size_t n_bytes;
    const int length = snprintf(name, sizeof name, "scene.%u.title", number);
    const char *title = length < (int)sizeof name ? sections_find_any(job, name, &n_bytes) : NULL;
    if (title != NULL) {
        snprintf(place->with, sizeof place->with, "%.*s", (int)n_bytes, title);
    }
}

RunPlace run_place_find(const char *lab, const Sections *job, const ProbeNote *note)
{
    RunPlace place = {0};
    const ProbeStep *step = step_find(lab, note);
    if (step == NULL) {
        return place;
    }
    place.where = step->where;
    place.task = step->task;
    if (step->kind == ON_INPUTS) {
        describe_inputs(step, job, note->input, &place);
    } else if (step->kind == ON_SCENE) {
        describe_scene(job, note->input, &place);
    } else if (step->kind == ON_LEVEL && note->input >= 1 && note->input <= TODO_LEVELS) {
        snprintf(place.with, sizeof place.with, "level %u", note->input);
    }
    return place;
}

ProbeNote run_note_load(const char *path)
{
    ProbeNote note;
    struct stat status;
    const int file = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    const int is_whole = file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
                         status.st_size == sizeof note &&
                         read(file, &note, sizeof note) == sizeof note;
    if (file >= 0) {
        close(file);
    }
    return is_whole ? note : (ProbeNote){.name = "?"};
}
