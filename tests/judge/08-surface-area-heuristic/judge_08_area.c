// Lab 08: surface_area on its inputs. See judge_08.h; judge_08_functions.c is the sibling.
#include "judge_08.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>

#define GIVEN                                                                                      \
    const BBox3D in = ((const Job08 *)job)->areas[i];                                              \
    const double found = ((const double *)answers)[i]
// NaN is not near to anything.
#define IS_FOUND(area) (fabs(found - (area)) <= SAH_AREA_TOLERANCE * fabs(area))

// ---- Right --------------------------------------------------------------------------------------

static double area_of(double x, double y, double z)
{
    return 2 * (x * y + y * z + z * x);
}

#define FROM(axis, other) ((double)in.max[axis] - (double)in.min[other])
#define X FROM(0, 0)
#define Y FROM(1, 1)
#define Z FROM(2, 2)
#define AREA area_of(X, Y, Z)

RIGHT(is_area, IS_FOUND(AREA))

// ---- Mistakes -----------------------------------------------------------------------------------

// One of the three products is a side times itself.
static int has_square(BBox3D in, double found)
{
    const double sides[3] = {X, Y, Z};
    int is_found = 0;
    for (int i = 0; i < 9; i++) {
        const double left_out = sides[i / 3] * sides[(i / 3 + 1) % 3], side = sides[i % 3];
        is_found |= IS_FOUND(AREA - 2 * left_out + 2 * side * side);
    }
    return is_found;
}

// One length is another difference, or a sum, of two of the six coordinates.
static double end_of(BBox3D in, int k)
{
    return k < 3 ? in.max[k] : in.min[k - 3];
}

static double with_length(BBox3D in, int way)
{
    const double a = end_of(in, way / 3 % 6), b = end_of(in, way / 18 % 6);
    double sides[3] = {X, Y, Z};
    sides[way % 3] = way < 108 ? a - b : a + b;
    return area_of(sides[0], sides[1], sides[2]);
}

// A bit for each of the three products: taken off, or divided.
static double with_faces(BBox3D in, int way)
{
    const double a[] = {X, Y, Z}, b[] = {Y, Z, X};
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const int is_other = way >> k & 1;
        sum += is_other && way >= 8 ? a[k] / b[k] : is_other ? -a[k] * b[k] : a[k] * b[k];
    }
    return 2 * sum;
}

#define UNSIGNED(axis) (fabs((double)in.max[axis]) - fabs((double)in.min[axis]))

// Only the tiny box is smaller, and only those that overflow in float are larger.
#define LONGEST fmax(fmax(X, Y), Z)

KNOWN_LIST(known)
{
    GIVEN;

    ANSWERS(one_side, AREA / 2, "that is half of the faces: each has its like on the other side");
    ANSWERS(without_x, AREA - 2 * Y * Z, "the two faces at right angles to x are missing");
    ANSWERS(without_y, AREA - 2 * Z * X, "the two faces at right angles to y are missing");
    ANSWERS(without_z, AREA - 2 * X * Y, "the two faces at right angles to z are missing");
    EACH(one_twice,
         IS_FOUND(4 * Y * Z + 2 * Z * X) || IS_FOUND(4 * Y * Z + 2 * X * Y) ||
             IS_FOUND(4 * Z * X + 2 * X * Y) || IS_FOUND(4 * Z * X + 2 * Y * Z) ||
             IS_FOUND(4 * X * Y + 2 * Y * Z) || IS_FOUND(4 * X * Y + 2 * Z * X),
         "one pair of faces counts twice, and another one is missing");
    EACH(cube, IS_FOUND(6 * Y * Z) || IS_FOUND(6 * Z * X) || IS_FOUND(6 * X * Y),
         "that is six times one of the faces: the sides may differ");
    ANSWERS(edges, 4 * (X + Y + Z), "that is the length of the twelve edges");
    ANSWERS(lengths, X + Y + Z, "that is the sum of the three lengths");
    ANSWERS(volume, (X * Y * Z), "that is the volume");
    ANSWERS(flat_is_nothing, (X * Y * Z) == 0 ? 0 : AREA,
            "a flat box has no volume, and still two faces");
    ANSWERS(flat_has_one_side, (X * Y * Z) == 0 ? AREA / 2 : AREA,
            "a flat box has two faces, too: both count");
    EACH(two_once,
         IS_FOUND(AREA / 2 + X * Y) || IS_FOUND(AREA / 2 + Y * Z) || IS_FOUND(AREA / 2 + Z * X),
         "only one pair of faces counts twice: each has its like on the other side");

    EACH(square, has_square(in, found),
         "a side is multiplied by itself: a face has two sides on different axes");

    ANY(other_length, 216, IS_FOUND(with_length(in, way)),
        "one length is not its axis' maximum minus its minimum: something else is computed");

    ANY(other_faces, 16, IS_FOUND(with_faces(in, way)),
        "of each pair of axes the two lengths are multiplied, and the three products added");
    // What a number beyond 32 bits is as a whole one, C leaves open.
    EACH(whole_lengths,
         fmax(fmax(X, Y), Z) > 0x1p30 || IS_FOUND(area_of(trunc(X), trunc(Y), trunc(Z))),
         "the lengths were cut to whole numbers");
    ANSWERS(whole_area, trunc(AREA), "the area was cut to a whole number");
    ANSWERS(from_zero, area_of(in.max[0], in.max[1], in.max[2]),
            "that is as if every box began at 0: a length is max - min");
    EACH(other_min,
         IS_FOUND(area_of(FROM(0, 1), Y, Z)) || IS_FOUND(area_of(FROM(0, 2), Y, Z)) ||
             IS_FOUND(area_of(X, FROM(1, 0), Z)) || IS_FOUND(area_of(X, FROM(1, 2), Z)) ||
             IS_FOUND(area_of(X, Y, FROM(2, 0))) || IS_FOUND(area_of(X, Y, FROM(2, 1))),
         "one length goes from the lowest coordinate of another axis");
    EACH(signs,
         IS_FOUND(area_of(UNSIGNED(0), UNSIGNED(1), UNSIGNED(2))) ||
             IS_FOUND(area_of(fabs(UNSIGNED(0)), fabs(UNSIGNED(1)), fabs(UNSIGNED(2)))),
         "coordinates may be negative: a length is max - min, with their signs");
    ONLY(small_lost, LONGEST < 0x1p-16 && found == 0,
         "however small a box is, it has an area: no epsilon");
    ONLY(large_lost, LONGEST > 0x1p60 && !isfinite(found),
         "in float a large box overflows: lengths and area are to be double");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("box %s: found %.9g, expected %.9g", words_box3d(in).text, found, AREA);
}

const Function area_08 = {"areas",
                          N_AREAS,
                          sizeof(double),
                          KNOWING(is_area, describe, known),
                          .counted = "boxes",
                          .is_known_by_range = 1};
