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

static double from(BBox3D in, int axis, int other)
{
    return (double)in.max[axis] - (double)in.min[other];
}

static double right_area(BBox3D in)
{
    return area_of(from(in, 0, 0), from(in, 1, 1), from(in, 2, 2));
}

// A length by which signs do not count.
static double unsigned_length(BBox3D in, int axis)
{
    return fabs((double)in.max[axis]) - fabs((double)in.min[axis]);
}

RIGHT(is_area, IS_FOUND(right_area(in)))

// ---- Mistakes -----------------------------------------------------------------------------------

// One of the three products is a side times itself.
static int has_square(BBox3D in, double found)
{
    const double sides[3] = {from(in, 0, 0), from(in, 1, 1), from(in, 2, 2)};
    int is_found = 0;
    for (int i = 0; i < 9; i++) {
        const double left_out = sides[i / 3] * sides[(i / 3 + 1) % 3], side = sides[i % 3];
        is_found |= IS_FOUND(right_area(in) - 2 * left_out + 2 * side * side);
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
    double sides[3] = {from(in, 0, 0), from(in, 1, 1), from(in, 2, 2)};
    sides[way % 3] = way < 108 ? a - b : a + b;
    return area_of(sides[0], sides[1], sides[2]);
}

// A bit for each of the three products: taken off, or divided.
static double with_faces(BBox3D in, int way)
{
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        const double a = from(in, k, k), b = from(in, next, next);
        const int is_other = way >> k & 1;
        sum += is_other && way >= 8 ? a / b : is_other ? -a * b : a * b;
    }
    return 2 * sum;
}

KNOWN_LIST(known)
{
    GIVEN;
    const double x = from(in, 0, 0), y = from(in, 1, 1), z = from(in, 2, 2);
    const double area = area_of(x, y, z), longest = fmax(fmax(x, y), z);

    ANSWERS(one_side, area / 2, "that is half of the faces: each has its like on the other side");
    ANSWERS(without_x, area - 2 * y * z, "the two faces at right angles to x are missing");
    ANSWERS(without_y, area - 2 * z * x, "the two faces at right angles to y are missing");
    ANSWERS(without_z, area - 2 * x * y, "the two faces at right angles to z are missing");
    EACH(one_twice,
         IS_FOUND(4 * y * z + 2 * z * x) || IS_FOUND(4 * y * z + 2 * x * y) ||
             IS_FOUND(4 * z * x + 2 * x * y) || IS_FOUND(4 * z * x + 2 * y * z) ||
             IS_FOUND(4 * x * y + 2 * y * z) || IS_FOUND(4 * x * y + 2 * z * x),
         "one pair of faces counts twice, and another one is missing");
    EACH(cube, IS_FOUND(6 * y * z) || IS_FOUND(6 * z * x) || IS_FOUND(6 * x * y),
         "that is six times one of the faces: the sides may differ");
    ANSWERS(edges, 4 * (x + y + z), "that is the length of the twelve edges");
    ANSWERS(lengths, x + y + z, "that is the sum of the three lengths");
    ANSWERS(volume, (x * y * z), "that is the volume");
    ANSWERS(flat_is_nothing, (x * y * z) == 0 ? 0 : area,
            "a flat box has no volume, and still two faces");
    ANSWERS(flat_has_one_side, (x * y * z) == 0 ? area / 2 : area,
            "a flat box has two faces, too: both count");
    EACH(two_once,
         IS_FOUND(area / 2 + x * y) || IS_FOUND(area / 2 + y * z) || IS_FOUND(area / 2 + z * x),
         "only one pair of faces counts twice: each has its like on the other side");

    EACH(square, has_square(in, found),
         "a side is multiplied by itself: a face has two sides on different axes");

    ANY(other_length, 216, IS_FOUND(with_length(in, way)),
        "one length is not its axis' maximum minus its minimum: something else is computed");

    ANY(other_faces, 16, IS_FOUND(with_faces(in, way)),
        "of each pair of axes the two lengths are multiplied, and the three products added");
    // What a number beyond 32 bits is as a whole one, C leaves open.
    EACH(whole_lengths, longest > 0x1p30 || IS_FOUND(area_of(trunc(x), trunc(y), trunc(z))),
         "the lengths were cut to whole numbers");
    ANSWERS(whole_area, trunc(area), "the area was cut to a whole number");
    ANSWERS(from_zero, area_of(in.max[0], in.max[1], in.max[2]),
            "that is as if every box began at 0: a length is max - min");
    EACH(other_min,
         IS_FOUND(area_of(from(in, 0, 1), y, z)) || IS_FOUND(area_of(from(in, 0, 2), y, z)) ||
             IS_FOUND(area_of(x, from(in, 1, 0), z)) || IS_FOUND(area_of(x, from(in, 1, 2), z)) ||
             IS_FOUND(area_of(x, y, from(in, 2, 0))) || IS_FOUND(area_of(x, y, from(in, 2, 1))),
         "one length goes from the lowest coordinate of another axis");
    EACH(
        signs,
        IS_FOUND(area_of(unsigned_length(in, 0), unsigned_length(in, 1), unsigned_length(in, 2))) ||
            IS_FOUND(area_of(fabs(unsigned_length(in, 0)), fabs(unsigned_length(in, 1)),
                             fabs(unsigned_length(in, 2)))),
        "coordinates may be negative: a length is max - min, with their signs");
    // Only the tiny box is smaller, and only those that overflow in float are larger.
    ONLY(small_lost, longest < 0x1p-16 && found == 0,
         "however small a box is, it has an area: no epsilon");
    ONLY(large_lost, longest > 0x1p60 && !isfinite(found),
         "in float a large box overflows: lengths and area are to be double");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("box %s: found %.9g, expected %.9g", words_box3d(in).text, found,
                       right_area(in));
}

const Function area_08 = {"areas",
                          N_AREAS,
                          sizeof(double),
                          KNOWING(is_area, describe, known),
                          .counted = "boxes",
                          .is_known_by_range = 1};
