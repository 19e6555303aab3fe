// Pictures in memory and in files: RGBA float, row 0 on top, through OpenImageIO.
//
// Files are in image_file.c, which calls OpenImageIO by way of image.cpp; the rest is in image.c
// and needs no library. EXR keeps every float and is what gets compared; PNG is
// for people.
// Read next: image.c, image_file.c.
#ifndef COMMON_IMAGE_H
#define COMMON_IMAGE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define IMAGE_CHANNELS 4  // red, green, blue, alpha

typedef struct Image {
    int width;      // pixels
    int height;     // pixels
    float *pixels;  // [height][width][IMAGE_CHANNELS]
} Image;

// Make a picture with every value 0. Returns 0, or -1 after one message on stderr (size not
// positive, no memory). Release with image_free().
int image_create(int width, int height, Image *image);

// Release the pixels; a zeroed Image is fine.
void image_free(Image *image);

// The length of a picture's path without its ending: for "a/b.png" that of "a/b". Returns 0 for a
// path that image_save() refuses: another ending than .exr or .png, or no name before it.
size_t image_stem_length(const char *path);

// Write a picture; the ending decides: .exr (32-bit float) or .png (8 bits, values clamped to 0..1;
// the picture is shown over black, opaque, as the lecture shows it; colours are premultiplied).
// The file appears whole or not at all: it is written beside its place and renamed.
// Returns 0, or -1 after one message on stderr.
int image_save(const Image *image, const char *path);

// A picture as the bytes of a file of `format`, "exr" or "png".
//   name             what a message calls it
//   bytes, n_bytes   out; release with free()
// Returns 0, or -1 after one message on stderr.
int image_encode(const Image *image, const char *format, const char *name, unsigned char **bytes,
                 size_t *n_bytes);

// Read a picture of any kind OpenImageIO knows into 4 channels (grey is spread, a missing alpha is
// 1). Returns 0, or -1 after one message on stderr. Release with image_free().
int image_load(const char *path, Image *image);

typedef struct ImageDifference {
    int same_size;         // 0: width or height differ, and nothing below is set
    int n_not_finite;      // pixels with a NaN or an infinity in either picture
    int n_different;       // pixels beyond the tolerance in some channel, or not finite
    int first_x, first_y;  // the first of those in reading order; -1, -1 when there is none
    float max_difference;  // the largest difference of one channel over finite pixels
} ImageDifference;

// Compare two pictures channel by channel. Sizes and finiteness are checked before anything else:
// a picture of NaNs, or a smaller one, never passes.
ImageDifference image_compare(const Image *image, const Image *reference, float tolerance);

// The colour of a value from 0 (nearly black) to 1 (pale yellow) in the inferno colour map; more
// than 1 is as 1.
//   rgb[3]   out
void image_heat_colour(float value, float *rgb);

// The least sum of the four channels' differences that has the brightest colour.
#define IMAGE_BRIGHTEST_DIFFERENCE 0.5f

// Where two pictures differ, for people: black where equal, the brighter the further apart
// (|difference| summed over the channels, up to the value above, in the inferno colours), and cyan
// where NaN. Both of the same size. Returns 0, or -1 after one message on stderr. Release with
// image_free().
int image_difference_picture(const Image *image, const Image *reference, Image *difference);

#ifdef __cplusplus
}
#endif

#endif
