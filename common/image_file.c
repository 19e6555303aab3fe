// Pictures in files (see image.h). The bytes are made and read by image.cpp, whose library is
// loaded with the first picture: see image_codec.h.
//
// Read next: output_file.h.
#include "complain.h"
#include "image_codec.h"
#include "output_file.h"
#include "text_file.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

// Returns NULL after one message about the picture that wanted it.
static const ImageCodec *codec_load(const char *path)
{
    // Found in the build folder, one above each program: the Makefile puts that into the programs.
    void *library = dlopen("libimage_codec.so", RTLD_LAZY | RTLD_LOCAL);
    const ImageCodec *codec = library != NULL ? dlsym(library, "image_codec") : NULL;
    if (codec == NULL) {
        complain("%s: OpenImageIO cannot be loaded: %s; run make anew", path, dlerror());
    }
    return codec;
}

// Put the bytes of a file in its place. Returns 0, or -1 after one message.
static int bytes_save(const char *path, const unsigned char *bytes, size_t n_bytes)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    // What fails in here marks the stream, and output_file_commit() reports it.
    fwrite(bytes, 1, n_bytes, output.file);
    return output_file_commit(&output);
}

int image_encode(const Image *image, const char *format, const char *name, unsigned char **bytes,
                 size_t *n_bytes)
{
    const ImageCodec *codec = codec_load(name);
    if (codec == NULL) {
        return -1;
    }
    char *fault = codec->encode(image, format, bytes, n_bytes);
    if (fault != NULL) {
        complain("%s: %s", name, fault);
    }
    const int result = fault != NULL ? -1 : 0;
    free(fault);
    return result;
}

int image_save(const Image *image, const char *path)
{
    const size_t stem_length = image_stem_length(path);
    if (stem_length == 0) {
        complain("%s: expected a file that ends in .exr or .png", path);
        return -1;
    }
    unsigned char *bytes;
    size_t n_bytes;
    const char *format = path + stem_length + 1;  // behind the point: "exr" or "png"
    if (image_encode(image, format, path, &bytes, &n_bytes) != 0) {
        return -1;
    }
    const int result = bytes_save(path, bytes, n_bytes);
    free(bytes);
    return result;
}

int image_load(const char *path, Image *image)
{
    *image = (Image){0};
    // OpenImageIO would wait for a pipe's writer, so the file is opened once before.
    FILE *file = text_file_open(path);
    if (file == NULL) {
        return -1;
    }
    fclose(file);
    const ImageCodec *codec = codec_load(path);
    if (codec == NULL) {
        return -1;
    }
    char *fault = codec->decode(path, image);
    if (fault != NULL) {
        complain("%s: %s", path, fault);
        image_free(image);
    }
    const int result = fault != NULL ? -1 : 0;
    free(fault);
    return result;
}
