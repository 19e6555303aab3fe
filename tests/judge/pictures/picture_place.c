// In which part of a picture it is wrong, or unwritten (see picture_looks.h).
#include "picture_looks.h"

#include "jobs.h"

#include <math.h>

// A part of a picture: pixels from a column on, and from a row on; none where these are its sides.
typedef struct Part {
    int first_column, first_row;
} Part;

typedef int IsIn(PixelPair pixel);

static int is_wrong(PixelPair pixel)
{
    return !is_same_color(pixel.own, pixel.wanted, pixel.tolerance);
}

static int is_missing(PixelPair pixel)
{
    return pixel.own[0] == UNWRITTEN;
}

// Are the pixels that are meant all from some column and from some row on? Then this is that part.
static int is_part(ProbeImage own, const ExpectedPicture *expected, IsIn *is_in, Part *part)
{
    const int width = expected->reference.width, height = expected->reference.height;
    *part = (Part){width, height};
    for (int x = width - 1; x >= 0 && is_in(pixel_pair(own, expected, x)); x--) {
        part->first_column = x;
    }
    for (int y = height - 1; y >= 0 && is_in(pixel_pair(own, expected, y * width)); y--) {
        part->first_row = y;
    }
    int i = 0, is_same = 1;
    for (; is_same && i < width * height; i++) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        is_same = is_in(pixel) == (pixel.x >= part->first_column || pixel.y >= part->first_row);
    }
    return is_same && part->first_column > 0 && part->first_row > 0;
}

// "the last column and the last row", "all from row 208 on"; "" for no part.
static Words part_words(Part part, int width, int height)
{
    const int has_columns = part.first_column < width, has_rows = part.first_row < height;
    const Words column = part.first_column == width - 1
                             ? words("the last column")
                             : words("all from column %d on", part.first_column);
    const Words row = part.first_row == height - 1 ? words("the last row")
                                                   : words("all from row %d on", part.first_row);
    return words("%s%s%s", has_columns ? column.text : "", has_columns && has_rows ? " and " : "",
                 has_rows ? row.text : "");
}

// Fewer wrong pixels than these say nothing of their place.
#define MIN_WRONG 48

static int are_enough(ProbeImage own, const ExpectedPicture *expected)
{
    int n = 0;
    for (int i = 0; n < MIN_WRONG && i < expected_n_pixels(expected); i++) {
        n += is_wrong(pixel_pair(own, expected, i));
    }
    return n == MIN_WRONG;
}

// The one channel in which a picture is wrong, or -1.
static int wrong_channel(ProbeImage own, const ExpectedPicture *expected)
{
    int found = -1;
    for (int i = 0; i < expected_n_pixels(expected); i++) {
        const PixelPair pixel = pixel_pair(own, expected, i);
        for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
            if (fabsf(pixel.own[channel] - pixel.wanted[channel]) > pixel.tolerance) {
                if (found >= 0 && found != channel) {
                    return -1;
                }
                found = channel;
            }
        }
    }
    return found;
}

Words picture_place(ProbeImage own, const ExpectedPicture *expected)
{
    static const char *const names[IMAGE_CHANNELS] = {"red", "green", "blue", "alpha"};
    if (!are_enough(own, expected)) {
        return words("%s", "");
    }
    const int channel = wrong_channel(own, expected);
    Part part;
    if (channel >= 0) {
        return words("right but for %s", names[channel]);
    }
    return is_part(own, expected, is_wrong, &part)
               ? words("right but for %s",
                       part_words(part, expected->reference.width, expected->reference.height).text)
               : words("%s", "");
}

int picture_is_swapped(ProbeImage own, const ExpectedPicture *expected)
{
    const int width = expected->reference.width, height = expected->reference.height;
    Part part;
    return width != height && is_part(own, expected, is_missing, &part) &&
           (part.first_column == height || part.first_row == width);
}

Words picture_cut(ProbeImage own, const ExpectedPicture *expected)
{
    Part part;
    if (!is_part(own, expected, is_missing, &part)) {
        return words("%s", "");
    }
    return words("cut off: %s missing%s",
                 part_words(part, expected->reference.width, expected->reference.height).text,
                 picture_is_swapped(own, expected)
                     ? ", as where x and y are swapped, or width and height"
                     : "");
}
