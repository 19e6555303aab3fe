// Lab 04: pixel_on_display on the job's pixels. See judge_04.h; judge_04_rays.c is the sibling.
//
// What is expected comes from oracle3d.h, in double precision; DISPLAY_ERROR_04 is how far float
// may be off.
#include "judge_04.h"

#include "message.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>

#define GIVEN                                                                                      \
    const PixelJob *in = &((const Job04 *)job)->pixels[i];                                         \
    const Vec3 found = ((const PixelAnswer *)answers)[i].on_display
#define IS_FOUND(point) is_near_04(found, point, error_of(in) * fmax(1, vector_length(point)))

static double error_of(const PixelJob *in)
{
    const double half = in->camera.fov / 2 * fmax(1, (double)in->height / in->width);
    return DISPLAY_ERROR_04 * fmax(half, 1);
}

// ---- Right --------------------------------------------------------------------------------------

static OracleVector expected(const PixelJob *in)
{
    static const OracleRules3D right = {0};
    return oracle3d_display(in->x, in->y, in->width, in->height, in->camera.fov, &right);
}

RIGHT(is_right, is_near_04(found, expected(in), error_of(in)))

// The sides only: which half of the display the point is in. The middle itself says nothing.
static int is_on_its_side(const PixelJob *in, Vec3 found)
{
    const int right_of_middle = 2 * in->x + 1 - in->width;
    const int above_middle = in->height - 2 * in->y - 1;
    // A corner may be on the other side of a middle pixel.
    return (abs(right_of_middle) <= 1 || (found.x > 0) == (right_of_middle > 0)) &&
           (abs(above_middle) <= 1 || (found.y > 0) == (above_middle > 0)) && found.z == 1 &&
           isfinite(found.x) && isfinite(found.y);
}

RIGHT(is_right_side, is_on_its_side(in, found))

// ---- Mistakes -----------------------------------------------------------------------------------

static double size_of(const PixelJob *in)
{
    return (double)in->camera.fov / in->width;
}

// The point at a column and a row, with pixels of this size.
static OracleVector point(const PixelJob *in, double column, double row, double size)
{
    return (OracleVector){(column - in->width / 2.0) * size, (in->height / 2.0 - row) * size, 1};
}

static OracleVector placed(const PixelJob *in, double column, double row)
{
    return point(in, column, row, size_of(in));
}

static OracleVector sized(const PixelJob *in, double size)
{
    return point(in, in->x + 0.5, in->y + 0.5, size);
}

// What a division of whole numbers takes off the half of an odd width or height.
static double off(int size)
{
    return size % 2 / 2.0;
}

// Counted from another place than the middle, on one axis or on both.
static OracleVector from(const PixelJob *in, double middle_x, double middle_y)
{
    return placed(in, in->x + 0.5 + in->width / 2.0 - middle_x,
                  in->y + 0.5 + in->height / 2.0 - middle_y);
}

// With another number for height / width.
static OracleVector with_aspect(const PixelJob *in, double aspect)
{
    OracleVector p = sized(in, size_of(in));
    p.y *= aspect * in->width / in->height;
    return p;
}

static OracleVector at(OracleVector p, double z)
{
    p.z = z;
    return p;
}

KNOWN_LIST(known)
{
    GIVEN;
    const double fov = in->camera.fov, size = size_of(in);
    const double x = in->x + 0.5, y = in->y + 0.5;

    ANSWERS(corner, placed(in, x - 0.5, y - 0.5),
            "shifted by half a pixel: that is the pixel's corner, not its middle",
            MISTAKE_SHIFTED_HALF);
    ANSWERS(far_corner, placed(in, x + 0.5, y + 0.5),
            "shifted by half a pixel: that is the pixel's far corner, not its middle",
            MISTAKE_SHIFTED_HALF);
#define HALF_ACROSS                                                                                \
    "shifted by half a pixel in one direction: the middle of the pixel is half a pixel on in "     \
    "both",                                                                                        \
        MISTAKE_SHIFTED_HALF
    ANSWERS(left_border, placed(in, x - 0.5, y), HALF_ACROSS);
    ANSWERS(right_border, placed(in, x + 0.5, y), HALF_ACROSS);
    ANSWERS(upper_border, placed(in, x, y - 0.5), HALF_ACROSS);
    ANSWERS(lower_border, placed(in, x, y + 0.5), HALF_ACROSS);
    ANSWERS(half_width, sized(in, 2 * size), "fov is the display's width, not half of it");
    ANSWERS(fov_height, sized(in, fov / in->height), "fov is the display's width, not its height");
    ANSWERS(angle, sized(in, 2 * tan(fov / 2) / in->width),
            "fov is a width at distance 1, not an angle");
    ANSWERS(longer_side, sized(in, fov / fmax(in->width, in->height)),
            "fov is the display's width, and not the longer side's");
    ANSWERS(mirrored, placed(in, in->width - x, y), "mirrored: x grows to the right",
            MISTAKE_MIRRORED_X);
    ANSWERS(flipped, placed(in, x, in->height - y),
            "flipped: row 0 is the top row, where y is largest", MISTAKE_FLIPPED_Y);
    ANSWERS(transposed, placed(in, y, x), "transposed: x counts columns and y rows",
            MISTAKE_TRANSPOSED);

    // Nobody counts from -1: the half that leads to the middle was taken off.
    ANSWERS(one_right, placed(in, x + 1, y),
            "shifted by one pixel to the right: columns count from 0", MISTAKE_SHIFTED_ONE);
    ANSWERS(one_left, placed(in, x - 1, y),
            "shifted by one pixel to the left: half a pixel has the wrong sign",
            MISTAKE_SHIFTED_ONE);
    ANSWERS(one_down, placed(in, x, y + 1), "shifted by one pixel down: rows count from 0",
            MISTAKE_SHIFTED_ONE);
    ANSWERS(one_up, placed(in, x, y - 1),
            "shifted by one pixel up: half a pixel has the wrong sign", MISTAKE_SHIFTED_ONE);
    ANSWERS(one_left_up, placed(in, x - 1, y - 1),
            "shifted by one pixel to the left and up: half a pixel has the wrong sign",
            MISTAKE_SHIFTED_ONE);
    ANSWERS(one_right_down, placed(in, x + 1, y + 1),
            "shifted by one pixel to the right and down: columns and rows count from 0",
            MISTAKE_SHIFTED_ONE);

    ANSWERS(
        whole_halves, placed(in, x + off(in->width), y + off(in->height)),
        "half of an odd width or height has lost its half: the division is one of whole numbers");
    ANSWERS(whole_half_width, placed(in, x + off(in->width), y),
            "half of an odd width has lost its half: the division is one of whole numbers");
    ANSWERS(whole_half_height, placed(in, x, y + off(in->height)),
            "half of an odd height has lost its half: the division is one of whole numbers");
    ANSWERS(halves_rounded_up, placed(in, x - off(in->width), y - off(in->height)),
            "half of an odd width or height was rounded up: the middle of the display lies in the "
            "middle of a pixel there");
    ANSWERS(
        whole_steps,
        placed(in, in->width / 2.0 + trunc(x - in->width / 2.0),
               in->height / 2.0 - trunc(in->height / 2.0 - y)),
        "steps from the middle are whole numbers there, but odd halves in pictures of even size");
#define SIZES_SWAPPED                                                                              \
    "the middle is counted with the other side's size: x with width, y with height"
    ANSWERS(x_with_height, from(in, in->height / 2.0, in->height / 2.0), SIZES_SWAPPED);
    ANSWERS(y_with_width, from(in, in->width / 2.0, in->width / 2.0), SIZES_SWAPPED);
    ANSWERS(sizes_swapped, from(in, in->height / 2.0, in->width / 2.0), SIZES_SWAPPED);
#define FROM_BORDER                                                                                \
    "the point is counted from the border: from the middle, half a size is taken off"
    ANSWERS(x_from_border, from(in, 0, in->height / 2.0), FROM_BORDER);
    ANSWERS(y_from_border, from(in, in->width / 2.0, 0), FROM_BORDER);
    ANSWERS(both_from_border, from(in, 0, 0), FROM_BORDER);
#define NOT_HALVED "the whole size was taken off: the middle is half of it"
    ANSWERS(x_not_halved, from(in, in->width, in->height / 2.0), NOT_HALVED);
    ANSWERS(y_not_halved, from(in, in->width / 2.0, in->height), NOT_HALVED);
    ANSWERS(not_halved, from(in, in->width, in->height), NOT_HALVED);
#define MIXED_AXES "the column and the row are mixed up: x comes from the column, y from the row"
    ANSWERS(row_twice, placed(in, y, y), MIXED_AXES);
    ANSWERS(column_twice, placed(in, x, x), MIXED_AXES);
    ANSWERS(one_step_less, sized(in, fov / (in->width - 1)),
            "the side of a pixel is fov by width: a picture has as many steps as pixels");
    ANSWERS(one_step_more, sized(in, fov / (in->width + 1)),
            "the side of a pixel is fov by width: a picture has as many steps as pixels");
    ANSWERS(half_fov, sized(in, size / 2),
            "your display is half as wide as fov: fov is its whole width");
    ANSWERS(no_fov, sized(in, 1.0 / in->width), "fov has no part in it: it is the display's width");
    ANSWERS(in_pixels, sized(in, 1), "that is a number of pixels: the display is fov wide");

    ANSWERS(
        from_border_to_border,
        placed(in, in->x * in->width / (in->width - 1.0), in->y * in->height / (in->height - 1.0)),
        "the first and the last pixel stand on the borders: a picture has as many steps as "
        "pixels, and a pixel's middle is half a step from the border");

    ANSWERS(no_squares, with_aspect(in, 1),
            "pixels are squares: y needs the same size of a pixel as x");
    ANSWERS(inverse_aspect, with_aspect(in, (double)in->width / in->height),
            "y is scaled by width / height: it is height / width");
    ANSWERS(whole_aspect, with_aspect(in, floor((double)in->height / in->width)),
            "height / width is a division of whole numbers there");
    ANSWERS(corner_from_whole_middle,
            placed(in, x - 0.5 + off(in->width), y - 0.5 + off(in->height)),
            "shifted by half a pixel, and half of an odd width or height has lost its half: that "
            "is the pixel's corner, from a middle in whole numbers",
            MISTAKE_SHIFTED_HALF);
    ANSWERS(behind, at(sized(in, size), -1), "the display stands before the eye: at z = 1, not -1");
#define AT_1 "the display stands at distance 1, the third part of the point"
    ANSWERS(at_the_eye, at(sized(in, size), 0), AT_1);
    ANSWERS(at_fov, at(sized(in, size), fov), AT_1);
    ANSWERS(behind_flipped, at(placed(in, x, in->height - y), -1),
            "the display stands before the eye, at z = 1, and row 0 is the top row, where y is "
            "largest");
    ANSWERS(made_unit, vector_unit(sized(in, size)),
            "the point was made a unit vector: it stands on the display, at z = 1");
    ANSWERS(width_1, at(sized(in, 1.0 / in->width), 1 / fov),
            "that display is 1 wide: it must stand at distance 1, and be as wide as fov");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const OracleVector e = expected(in);
    return message_new("pixel (%d, %d) of %dx%d, fov %g: found %s, expected %s", in->x, in->y,
                       in->width, in->height, in->camera.fov, words_vec3(found, 6).text,
                       words_xyz(e.x, e.y, e.z, 6).text);
}

const Function display_sides_04 = {"pixels", N_ALL_PIXELS, sizeof(PixelAnswer),
                                   KNOWING(is_right_side, describe, known), .counted = "points"};
const Function display_04 = {"pixels",
                             N_ALL_PIXELS,
                             sizeof(PixelAnswer),
                             KNOWING(is_right, describe, known),
                             .counted = "points",
                             .is_known_by_range = 1};
