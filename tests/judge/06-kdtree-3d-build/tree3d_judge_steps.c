// What one step of the building must give: a box, an axis, a plane, a sphere in a cell. And where
// float may round, what else it may give.
#include "tree3d_judge.h"

#include "message.h"
#include "overlap_reach.h"
#include "words.h"

#include <float.h>
#include <math.h>

// ---- A sphere and a cell ------------------------------------------------------------------------

// How far squared distance and squared radius may be apart, relative to the latter, and still come
// out of double in the other order. With u = DBL_EPSILON / 2 the distance on an axis is off by u,
// its square by 3u, the sum of three by 5u, the squared radius by u: 6u together. So 8u.
#define TOUCH_TOLERANCE (4 * DBL_EPSILON)

// Is the square of a distance exact, and so coarse beside the largest of the numbers that are added
// and compared that double, with its 53 bits, does so in any order without rounding? (Roots are
// rounded all the same: who compares them is wrong.)
static int is_exact_beside(double distance, double largest)
{
    int exponent;
    frexp(largest, &exponent);
    const double square = distance * distance;
    return fma(distance, distance, -square) == 0 && fmod(square, ldexp(1, exponent - 53)) == 0;
}

SphereInCell tree3d_judge_sphere(Sphere sphere, BBox3D cell)
{
    const double centre[3] = {sphere.x, sphere.y, sphere.z}, radius = sphere.radius;
    double outside[3], distance2 = 0;
    for (int axis = 0; axis < 3; axis++) {
        outside[axis] = outside_of(centre[axis], cell.min[axis], cell.max[axis]);
        distance2 += outside[axis] * outside[axis];
    }
    const double radius2 = radius * radius, largest = fmax(distance2, radius2);
    if (fabs(distance2 - radius2) <= TOUCH_TOLERANCE * radius2 &&
        !(is_exact_beside(radius, largest) && is_exact_beside(outside[0], largest) &&
          is_exact_beside(outside[1], largest) && is_exact_beside(outside[2], largest))) {
        return SPHERE_EITHER;
    }
    return distance2 <= radius2 ? SPHERE_INSIDE : SPHERE_OUTSIDE;
}

// ---- The scene's box ----------------------------------------------------------------------------

// What a float holds of the scene's box. A centre plus or minus a radius is rounded once, whether
// in float or in double before.
BBox3D tree3d_expected_box(const Sphere *spheres, u32 n_spheres)
{
    if (n_spheres == 0) {
        return (BBox3D){{0}, {0}};
    }
    BBox3D box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (u32 i = 0; i < n_spheres; i++) {
        const double centre[3] = {spheres[i].x, spheres[i].y, spheres[i].z};
        const double radius = fabs((double)spheres[i].radius);
        for (int axis = 0; axis < 3; axis++) {
            box.min[axis] = fminf(box.min[axis], (float)(centre[axis] - radius));
            box.max[axis] = fmaxf(box.max[axis], (float)(centre[axis] + radius));
        }
    }
    return box;
}

// ---- Axis and plane -----------------------------------------------------------------------------

static int is_float(double value)
{
    return (double)(float)value == value;
}

// A side's length: exact, or as float rounds it.
static double side(BBox3D cell, u32 axis, int in_float)
{
    const double length = (double)cell.max[axis] - (double)cell.min[axis];
    return in_float ? (double)(float)length : length;
}

// The axis of the longest side, the first where sides are equal.
static u32 longest_axis(BBox3D cell, int in_float)
{
    u32 longest = 0;
    for (u32 axis = 0; axis < 3; axis++) {
        if (side(cell, axis, in_float) > side(cell, longest, in_float)) {
            longest = axis;
        }
    }
    return longest;
}

u32 tree3d_expected_axis(BBox3D cell)
{
    return longest_axis(cell, 0);
}

// Why an axis is the wrong one, or NULL.
static const char *explain_axis(BBox3D cell, u32 axis, u32 expected)
{
    if (axis >= 3) {
        return "there are axes 0, 1 and 2";
    }
    const double length = side(cell, axis, 0), longest = side(cell, expected, 0);
    const int is_shortest =
        length <= side(cell, 0, 0) && length <= side(cell, 1, 0) && length <= side(cell, 2, 0);
    return length == longest ? "of equal sides the first counts"
           : longest - length < longest / 1024
               ? "these sides are not equal, if nearly, and the longest is split"
           : is_shortest ? "that side is the shortest"
                         : NULL;
}

Diagnosis tree3d_judge_axis(const char *where, BBox3D cell, u32 axis)
{
    // Two sides may differ by less than float sees.
    const u32 expected = tree3d_expected_axis(cell);
    if (axis == expected || axis == longest_axis(cell, 1)) {
        return NOTHING_WRONG;
    }
    const char *looks = explain_axis(cell, axis, expected);
    return diagnosis_of(message_new("%s: cell %s: found axis %u, expected %u (%c)%s", where,
                                    words_box3d(cell).text, axis, expected, "xyz"[expected],
                                    looks == NULL ? ", that side is not the longest" : ""),
                        (Cause){.says = looks});
}

// The cell's middle on an axis.
static double middle(BBox3D cell, u32 axis)
{
    return (double)cell.min[axis] + side(cell, axis, 0) / 2;
}

f32 tree3d_expected_middle(BBox3D cell, u32 axis)
{
    return (f32)middle(cell, axis);
}

Diagnosis tree3d_judge_middle(const char *where, BBox3D cell, u32 axis, f32 pos)
{
    const double min = cell.min[axis], max = cell.max[axis];
    const double expected = middle(cell, axis);
    // (min + max) / 2 and min + (max - min) / 2 round one sum or two numbers, each by half of
    // FLT_EPSILON, and none is larger than the larger end.
    if (fabs((double)pos - expected) <= (double)FLT_EPSILON * fmax(fabs(min), fabs(max))) {
        return NOTHING_WRONG;
    }
    const Words from = words_float(cell.min[axis]), to = words_float(cell.max[axis]);
    const Words middle_words = words_float((float)expected);
    if (isnan(pos)) {
        return diagnosis_new("%s: cell from %s to %s on axis %u (%c): found no number (NaN) for "
                             "the split, expected %s",
                             where, from.text, to.text, axis, "xyz"[axis], middle_words.text);
    }
    const char *looks = max > min && pos == (max - min) / 2
                            ? "that is half the length, as if the cell began at 0"
                            : NULL;
    return diagnosis_of(
        message_new("%s: cell from %s to %s on axis %u (%c): found split at %s, expected %s", where,
                    from.text, to.text, axis, "xyz"[axis], words_float(pos).text,
                    middle_words.text),
        (Cause){.says = looks});
}

int tree3d_judge_is_exact_cell(BBox3D cell)
{
    int is_exact = 1;
    for (u32 axis = 0; axis < 3; axis++) {
        const double middle = ((double)cell.min[axis] + (double)cell.max[axis]) / 2;
        is_exact = is_exact && is_float(side(cell, axis, 0)) && is_float(middle);
    }
    return is_exact;
}
