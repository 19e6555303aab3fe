// Pictures as the bytes of a file and back: what image.cpp, the only door to OpenImageIO, does for
// image_file.c.
//
// image.cpp is a library of its own, libimage_codec.so, which is loaded with the first picture that
// is read or written: OpenImageIO brings some 260 libraries, and linking them takes longer than
// most programs run that end with a message or a verdict. It needs nothing of ours, and no C++
// exception leaves it: one that reached C code would end the program without a message.
#ifndef COMMON_IMAGE_CODEC_H
#define COMMON_IMAGE_CODEC_H

#include "image.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ImageCodec {
    // A picture as a file of `format`, "exr" or "png".
    //   bytes, n_bytes   out; release with free()
    // Returns NULL, or what went wrong, for a message; release with free().
    char *(*encode)(const Image *image, const char *format, unsigned char **bytes, size_t *n_bytes);

    // A picture of any kind that OpenImageIO knows, in 4 channels.
    //   image   out; release with image_free()
    // Returns as above.
    char *(*decode)(const char *path, Image *image);
} ImageCodec;

// What image.cpp defines, and image_file.c finds by this name.
extern const ImageCodec image_codec;

#ifdef __cplusplus
}
#endif

#endif
