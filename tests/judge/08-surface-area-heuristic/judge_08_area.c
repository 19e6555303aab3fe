// Lab 08: surface_area on its inputs. See judge_08.h; judge_08_functions.c is the sibling.
#include "judge_08.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>

// ---- Mistakes -----------------------------------------------------------------------------------

// A box's three lengths.
typedef struct Lengths {
    double of[3];
} Lengths;

// Each from the lowest coordinate of an axis: its own in "xyz".
static Lengths lengths_from(BBox3D box, const char *from)
{
    Lengths lengths;
    for (int axis = 0; axis < 3; axis++) {
        lengths.of[axis] = (double)box.max[axis] - box.min[from[axis] - 'x'];
    }
    return lengths;
}

static Lengths lengths_of(BBox3D box)
{
    return lengths_from(box, "xyz");
}

// The sum of the faces at right angles to x, y and z, each with how often it counts.
static double faces_of(Lengths lengths, const double counts[3])
{
    const double x = lengths.of[0], y = lengths.of[1], z = lengths.of[2];
    return counts[0] * (y * z) + counts[1] * (z * x) + counts[2] * (x * y);
}

static double area_of(Lengths lengths)
{
    static const double both_sides[3] = {2, 2, 2};
    return faces_of(lengths, both_sides);
}

// A known mistake, and what is said about it; number 0 is none.
typedef struct AreaMistake {
    Cause cause;
    double (*area)(BBox3D box);  // what comes of it, or NULL:
    double faces[3];             // how often each face counts, where this is not 0
    const char *from;   // where each length begins: "yyz" is x from the lowest y, else NULL
    int is_lost_small;  // the smallest box has no area, and all else is right
    int is_lost_large;  // the largest ones have no number for it
} AreaMistake;

static double edges(BBox3D box)
{
    return sah_size(box, SAH_EDGES);
}

static double volume(BBox3D box)
{
    return sah_size(box, SAH_VOLUME);
}

static double sum_of_lengths(BBox3D box)
{
    return sah_size(box, SAH_EDGES) / 4;
}

static int is_flat(BBox3D box)
{
    return sah_size(box, SAH_VOLUME) == 0;
}

static double flat_is_nothing(BBox3D box)
{
    return is_flat(box) ? 0 : area_of(lengths_of(box));
}

static double flat_has_one_side(BBox3D box)
{
    return area_of(lengths_of(box)) / (is_flat(box) ? 2 : 1);
}

static double in_whole_lengths(BBox3D box)
{
    Lengths lengths = lengths_of(box);
    for (int axis = 0; axis < 3; axis++) {
        lengths.of[axis] = trunc(lengths.of[axis]);
    }
    return area_of(lengths);
}

static double in_whole_numbers(BBox3D box)
{
    return trunc(area_of(lengths_of(box)));
}

static double from_zero(BBox3D box)
{
    Lengths lengths;
    for (int axis = 0; axis < 3; axis++) {
        lengths.of[axis] = box.max[axis];
    }
    return area_of(lengths);
}

static Lengths lengths_without_signs(BBox3D box)
{
    Lengths lengths;
    for (int axis = 0; axis < 3; axis++) {
        lengths.of[axis] = fabs((double)box.max[axis]) - fabs((double)box.min[axis]);
    }
    return lengths;
}

static double without_signs(BBox3D box)
{
    return area_of(lengths_without_signs(box));
}

static double without_any_sign(BBox3D box)
{
    Lengths lengths = lengths_without_signs(box);
    for (int axis = 0; axis < 3; axis++) {
        lengths.of[axis] = fabs(lengths.of[axis]);
    }
    return area_of(lengths);
}

#define ONE_TWICE "one pair of faces counts twice, and another one is missing"
#define OTHER_MIN "one length goes from the lowest coordinate of another axis"
#define SIGNS "coordinates may be negative: a length is max - min, with their signs"
#define CUBE "that is six times one of the faces: the sides may differ"

static const AreaMistake area_mistakes[] = {
    {.cause = {0}},
    {{.says = "that is half of the faces: each has its like on the other side"},
     .faces = {1, 1, 1}},
    {{.says = "the two faces at right angles to x are missing"}, .faces = {0, 2, 2}},
    {{.says = "the two faces at right angles to y are missing"}, .faces = {2, 0, 2}},
    {{.says = "the two faces at right angles to z are missing"}, .faces = {2, 2, 0}},
    {{.says = ONE_TWICE}, .faces = {0, 2, 4}},
    {{.says = ONE_TWICE}, .faces = {0, 4, 2}},
    {{.says = ONE_TWICE}, .faces = {2, 0, 4}},
    {{.says = ONE_TWICE}, .faces = {4, 0, 2}},
    {{.says = ONE_TWICE}, .faces = {2, 4, 0}},
    {{.says = ONE_TWICE}, .faces = {4, 2, 0}},
    {{.says = CUBE}, .faces = {6, 0, 0}},
    {{.says = CUBE}, .faces = {0, 6, 0}},
    {{.says = CUBE}, .faces = {0, 0, 6}},
    {{.says = "that is the length of the twelve edges"}, .area = edges},
    {{.says = "that is the sum of the three lengths"}, .area = sum_of_lengths},
    {{.says = "that is the volume"}, .area = volume},
    {{.says = "a flat box has no volume, and still two faces"}, .area = flat_is_nothing},
    {{.says = "a flat box has two faces, too: both count"}, .area = flat_has_one_side},
    {{.says = "the lengths were cut to whole numbers"}, .area = in_whole_lengths},
    {{.says = "the area was cut to a whole number"}, .area = in_whole_numbers},
    {{.says = "that is as if every box began at 0: a length is max - min"}, .area = from_zero},
    {{.says = SIGNS}, .area = without_signs},
    {{.says = SIGNS}, .area = without_any_sign},
    {{.says = OTHER_MIN}, .from = "yyz"},
    {{.says = OTHER_MIN}, .from = "zyz"},
    {{.says = OTHER_MIN}, .from = "xxz"},
    {{.says = OTHER_MIN}, .from = "xzz"},
    {{.says = OTHER_MIN}, .from = "xyx"},
    {{.says = OTHER_MIN}, .from = "xyy"},
    {{.says = "however small a box is, it has an area: no epsilon"}, .is_lost_small = 1},
    {{.says = "in float a large box overflows: lengths and area are to be double"},
     .is_lost_large = 1},
};

// ---- Judging ------------------------------------------------------------------------------------

// Only the tiny box is smaller, and only those that overflow in float are larger.
#define SMALL 0x1p-16
#define LARGE 0x1p60

static double longest_of(BBox3D box)
{
    const Lengths lengths = lengths_of(box);
    return fmax(fmax(lengths.of[0], lengths.of[1]), lengths.of[2]);
}

static double expected_area(BBox3D box, const AreaMistake *mistake)
{
    const double *faces = mistake->faces;
    const int counts_faces = faces[0] + faces[1] + faces[2] > 0;
    return mistake->area != NULL   ? mistake->area(box)
           : mistake->from != NULL ? area_of(lengths_from(box, mistake->from))
           : counts_faces          ? faces_of(lengths_of(box), faces)
                                   : area_of(lengths_of(box));
}

static int area_agrees(const void *pointer, int i, const void *answers, int number)
{
    const BBox3D box = ((const Job08 *)pointer)->areas[i];
    const AreaMistake *mistake = &area_mistakes[number];
    const double found = ((const double *)answers)[i], expected = expected_area(box, mistake);
    if (mistake->is_lost_large && longest_of(box) > LARGE && !isfinite(found)) {
        return 1;
    }
    if (mistake->is_lost_small && longest_of(box) < SMALL && found == 0) {
        return 1;
    }
    // NaN is not near to anything.
    return fabs(found - expected) <= SAH_AREA_TOLERANCE * fabs(expected);
}

static char *describe_area(const void *pointer, int i, const void *answers)
{
    const BBox3D box = ((const Job08 *)pointer)->areas[i];
    return message_new("box %s: found %.9g, expected %.9g", words_box3d(box).text,
                       ((const double *)answers)[i], sah_size(box, SAH_AREA));
}

const Function area_08 = {"areas", N_AREAS, sizeof(double),
                          COMPARED(area_agrees, describe_area, area_mistakes), .counted = "boxes"};
