// Molecules as 3D scenes (see molecule.h).
//
// Read next: molecule_xyz.c.
#include "molecule.h"

#include "message.h"
#include "number.h"

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

// How far from the origin an atom may be, Angstrom: a tenth of a millimetre. Beyond, float leaves
// less than two digits of a bond's length.
#define LARGEST_COORDINATE 1000000
#define LARGEST NUMBER_TEXT(LARGEST_COORDINATE)

#define VIEW_ANGLE 35.0  // degrees
// The view's distance, as a multiple of the one at which the outermost atom would touch the
// picture's edge.
#define VIEW_MARGIN 1.08

static const Vec3 BACKGROUND_COLOR = {0.03f, 0.04f, 0.08f};

// ---- Atoms --------------------------------------------------------------------------------------

void molecule_begin(Molecule *molecule, FILE *file, const char *name)
{
    memset(molecule, 0, sizeof *molecule);
    line_reader_begin(&molecule->lines, file, name);
    molecule->builder.reader = &molecule->lines;
}

float molecule_read_coordinate(Molecule *molecule, const char *axis, const char *text)
{
    float value = 0;
    const char *expected = NULL;
    if (number_read_float(text, &value) != 0) {
        expected = "a finite number";
    } else if (fabsf(value) > LARGEST_COORDINATE) {
        expected = "a number from -" LARGEST " to " LARGEST;
    }
    if (expected != NULL) {
        char where[16], found[LINE_QUOTE_SIZE];
        snprintf(where, sizeof where, "%s: ", axis);
        line_fault(&molecule->lines, where, line_quote(text, found), expected);
        return 0;
    }
    return value;
}

static void unknown_count(Molecule *molecule, const char *name)
{
    char quoted[LINE_QUOTE_SIZE];
    line_quote(name, quoted);
    molecule->n_unknown++;
    for (int i = 0; i < molecule->n_names; i++) {
        if (strcmp(molecule->names[i], quoted) == 0) {
            return;
        }
    }
    if (molecule->n_names == MOLECULE_MAX_NAMES) {
        molecule->has_more_names = 1;
        return;
    }
    strcpy(molecule->names[molecule->n_names++], quoted);
}

void molecule_add_atom(Molecule *molecule, Vec3 point, const Element *element, const char *name)
{
    if (element == NULL) {
        unknown_count(molecule, name);
        element = &ELEMENT_UNKNOWN;
    }
    const Material material = {
        .color = {(float)(element->color >> 16) / 255, (float)(element->color >> 8 & 255) / 255,
                  (float)(element->color & 255) / 255},
        .kd = 0.9f,
        .ks = 0.1f,
        .shine = 30,
        .refraction = 1,
    };
    builder_add_sphere(&molecule->builder, (Sphere){point.x, point.y, point.z, element->radius},
                       builder_add_material(&molecule->builder, &material));
}

// ---- The view -----------------------------------------------------------------------------------

// The box around all atoms, and which of the picture's directions each of its sides gets: the
// longest runs to the right, the shortest towards the eye. So a flat molecule shows its face.
typedef struct Frame {
    double center[3];
    int right, up, depth;  // axes: 0 is x, 1 is y, 2 is z
} Frame;

static Frame frame_of_atoms(const Scene3D *scene)
{
    double low[3] = {INFINITY, INFINITY, INFINITY};
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < scene->n_spheres; i++) {
        const Sphere *atom = &scene->spheres[i];
        const double center[3] = {atom->x, atom->y, atom->z};
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = fmin(low[axis], center[axis] - atom->radius);
            high[axis] = fmax(high[axis], center[axis] + atom->radius);
        }
    }
    Frame frame = {.right = 0, .depth = 2};
    for (int axis = 0; axis < 3; axis++) {
        frame.center[axis] = (low[axis] + high[axis]) / 2;
        if (high[axis] - low[axis] > high[frame.right] - low[frame.right]) {
            frame.right = axis;
        }
    }
    frame.depth = frame.right == 2 ? 1 : 2;
    for (int axis = 2; axis >= 0; axis--) {
        if (axis != frame.right && high[axis] - low[axis] < high[frame.depth] - low[frame.depth]) {
            frame.depth = axis;
        }
    }
    frame.up = 3 - frame.right - frame.depth;
    return frame;
}

// A direction by its shares along the frame's three axes.
static void frame_direction(const Frame *frame, double right, double up, double depth,
                            double *direction)
{
    direction[frame->right] = right;
    direction[frame->up] = up;
    direction[frame->depth] = depth;
}

static Vec3 frame_point(const Frame *frame, double distance, const double *direction)
{
    return (Vec3){(f32)(frame->center[0] + distance * direction[0]),
                  (f32)(frame->center[1] + distance * direction[1]),
                  (f32)(frame->center[2] + distance * direction[2])};
}

// The smallest distance from the box's centre, in a direction (a unit vector), at which all atoms
// are inside the cone that the eye sees. An atom, `ahead` of the centre towards the eye and `aside`
// of the axis, touches the cone of half angle a from within when
//     (distance - ahead) sin a - aside cos a = radius.
static double fitting_distance(const Scene3D *scene, const Frame *frame, const double *direction)
{
    const double half_angle = VIEW_ANGLE / 2 * M_PI / 180;
    double distance = 0;
    for (int i = 0; i < scene->n_spheres; i++) {
        const Sphere *atom = &scene->spheres[i];
        const double offset[3] = {atom->x - frame->center[0], atom->y - frame->center[1],
                                  atom->z - frame->center[2]};
        double ahead = 0, offset2 = 0;
        for (int axis = 0; axis < 3; axis++) {
            ahead += offset[axis] * direction[axis];
            offset2 += offset[axis] * offset[axis];
        }
        const double aside = sqrt(fmax(offset2 - ahead * ahead, 0));
        const double fitting = ahead + (aside * cos(half_angle) + atom->radius) / sin(half_angle);
        distance = fmax(distance, fitting);
    }
    return distance;
}

// From the front, a little to the right and above: depth shows, and no face hides the one behind
// it.
static void view_place(Molecule *molecule)
{
    Scene3D *scene = &molecule->builder.scene;
    const Frame frame = frame_of_atoms(scene);
    double direction[3], up[3];
    frame_direction(&frame, 0.2, 0.35, sqrt(1 - 0.2 * 0.2 - 0.35 * 0.35), direction);
    frame_direction(&frame, 0, 1, 0, up);
    const double distance = VIEW_MARGIN * fitting_distance(scene, &frame, direction);

    scene->view = (View){
        .from = frame_point(&frame, distance, direction),
        .at = frame_point(&frame, 0, direction),
        .up = {(f32)up[0], (f32)up[1], (f32)up[2]},
        .angle = (f32)VIEW_ANGLE,
        .hither = 1,
    };
    scene->background = BACKGROUND_COLOR;
    scene->width = SCENE3D_DEFAULT_SIZE;
    scene->height = SCENE3D_DEFAULT_SIZE;

    // As photographers do it: the main light from the left above, a weaker one from the right that
    // fills its shadows, and one from behind that draws the edge.
    static const struct {
        double right, up, depth;
        Vec3 color;
    } LIGHTS[] = {
        {-1.0, 1.2, 1.5, {1.00f, 1.00f, 0.97f}},
        {1.5, 0.0, 1.0, {0.30f, 0.33f, 0.40f}},
        {0.3, 1.5, -1.5, {0.30f, 0.30f, 0.35f}},
    };
    for (size_t i = 0; i < sizeof LIGHTS / sizeof LIGHTS[0]; i++) {
        double place[3];
        frame_direction(&frame, LIGHTS[i].right, LIGHTS[i].up, LIGHTS[i].depth, place);
        builder_add_light(&molecule->builder,
                          (Light){frame_point(&frame, distance, place), LIGHTS[i].color});
    }
}

// ---- The end ------------------------------------------------------------------------------------

void molecule_leave_out(Molecule *molecule, const char *rest, const char *of,
                        int (*is_counted)(const char *line))
{
    char *line = NULL;
    size_t size = 0;
    while (getline(&line, &size, molecule->lines.file) >= 0) {
        molecule->n_rest += is_counted(line);
    }
    free(line);
    molecule->rest = rest;
    molecule->of = of;
}

enum { WARNING_SIZE = MOLECULE_MAX_NAMES * (LINE_QUOTE_SIZE + 2) + 512 };

__attribute__((format(printf, 2, 3))) static void warning_add(char *warning, const char *format,
                                                              ...)
{
    size_t length = strlen(warning);
    if (length > 0) {
        length += (size_t)snprintf(warning + length, WARNING_SIZE - length, "; ");
    }
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(warning + length, WARNING_SIZE - length, format, arguments);
    va_end(arguments);
}

static void warn(const Molecule *molecule)
{
    char names[MOLECULE_MAX_NAMES * (LINE_QUOTE_SIZE + 2)] = "";
    char warning[WARNING_SIZE] = "";
    for (int i = 0; i < molecule->n_names; i++) {
        strcat(names, i == 0 ? "" : ", ");
        strcat(names, molecule->names[i]);
    }
    if (molecule->n_unknown > 0) {
        warning_add(warning, "drew %d atom%s of unknown elements in pink: %s%s",
                    molecule->n_unknown, plural((unsigned)molecule->n_unknown), names,
                    molecule->has_more_names ? " and others" : "");
    }
    if (molecule->n_elsewhere > 0) {
        warning_add(warning, "left out %" PRId64 " alternate location%s of atoms",
                    molecule->n_elsewhere, plural((unsigned)molecule->n_elsewhere));
    }
    if (molecule->n_rest > 0) {
        warning_add(warning, "left out %" PRId64 " %s%s %s", molecule->n_rest, molecule->rest,
                    plural((unsigned)molecule->n_rest), molecule->of);
    }
    if (molecule->cut_line > 0) {
        warning_add(warning, "the file ends too soon, within the name of a record in line %" PRId64,
                    molecule->cut_line);
    }
    line_warn(&molecule->lines, warning);
}

int molecule_finish(Molecule *molecule, Scene3D *scene)
{
    if (!molecule->lines.failed && molecule->builder.scene.n_spheres == 0) {
        line_fault(&molecule->lines, "", "no atoms", "at least one");
    }
    if (!molecule->lines.failed) {
        view_place(molecule);
    }
    if (builder_finish(&molecule->builder, scene) != 0) {
        return -1;
    }
    warn(molecule);
    return 0;
}
