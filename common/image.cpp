// Pictures as the bytes of a file and back (see image_codec.h): the one C++ file, around
// OpenImageIO.
//
// Read next: image_file.c, which calls it; image.c, where pictures are made and judged.
#include "image_codec.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace
{

// Three bytes a pixel, each the nearest; of two that are equally near the even one, as devices and
// windows round. Colours are premultiplied by alpha, so over black they are what they are.
std::vector<unsigned char> bytes_over_black(const Image *image)
{
    size_t n_pixels = (size_t)image->width * (size_t)image->height;
    std::vector<unsigned char> bytes(n_pixels * 3);
    for (size_t pixel = 0; pixel < n_pixels; pixel++) {
        for (size_t channel = 0; channel < 3; channel++) {
            float value = image->pixels[pixel * IMAGE_CHANNELS + channel];
            // Written so that a NaN fails the first comparison and becomes 0.
            float clamped = value > 0 ? std::min(value, 1.0f) : 0.0f;
            bytes[pixel * 3 + channel] = (unsigned char)std::lrint(clamped * 255.0f);
        }
    }
    return bytes;
}

// A picture as the bytes of a file. Made in memory because OpenImageIO's own files do not notice
// when the disk is full: a cut picture would pass for a whole one.
//   bytes   out
// Returns what went wrong; empty when nothing did.
std::string encode(const Image *image, const char *format, std::vector<unsigned char> *bytes)
{
    std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) {
        return "cannot be written in this format: " + OIIO::geterror();
    }

    bool as_bytes = std::strcmp(format, "png") == 0;
    OIIO::TypeDesc type = as_bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(image->width, image->height, as_bytes ? 3 : IMAGE_CHANNELS, type);
    OIIO::Filesystem::IOVecOutput memory(*bytes);
    bool written = output->set_ioproxy(&memory) && output->open(format, spec);
    if (written && as_bytes) {
        written = output->write_image(type, bytes_over_black(image).data());
    } else if (written) {
        written = output->write_image(type, image->pixels);
    }
    // Closing writes what is still to come, so it can fail as well. It must happen before `memory`
    // is gone.
    if (!written || !output->close()) {
        return "cannot be written: " + output->geterror();
    }
    return "";
}

// Memory that C code may free. Throws when there is none.
void *allocate(size_t n_values, size_t n_bytes_each)
{
    void *memory = std::calloc(n_values, n_bytes_each);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

// Spread 1 (grey), 2 (grey, alpha) or 3 channels (colour) to 4; more than 4 were never read.
void spread_channels(const std::vector<float> &values, int n_channels, Image *image)
{
    size_t n_pixels = (size_t)image->width * (size_t)image->height;
    bool grey = n_channels < 3;
    bool alpha = n_channels == 2 || n_channels == 4;
    for (size_t pixel = 0; pixel < n_pixels; pixel++) {
        const float *source = &values[pixel * (size_t)n_channels];
        float *target = image->pixels + pixel * IMAGE_CHANNELS;
        for (int channel = 0; channel < 3; channel++) {
            target[channel] = source[grey ? 0 : channel];
        }
        target[3] = alpha ? source[n_channels - 1] : 1.0f;
    }
}

// Returns what went wrong; empty when nothing did.
std::string decode(const char *path, Image *image)
{
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
    if (!input) {
        return "cannot be read: " + OIIO::geterror();
    }
    const OIIO::ImageSpec spec = input->spec();
    if (spec.depth > 1 || spec.deep || spec.nchannels < 1) {
        return "not a flat picture";
    }

    int n_channels = std::min(spec.nchannels, IMAGE_CHANNELS);
    size_t n_pixels = (size_t)spec.width * (size_t)spec.height;
    std::vector<float> values(n_pixels * (size_t)n_channels);
    if (!input->read_image(0, 0, 0, n_channels, OIIO::TypeDesc::FLOAT, values.data())) {
        return "cannot be read: " + input->geterror();
    }
    image->width = spec.width;
    image->height = spec.height;
    image->pixels = (float *)allocate(n_pixels, IMAGE_CHANNELS * sizeof(float));
    spread_channels(values, n_channels, image);
    return "";
}

// A fault in words, which C code may free; NULL for none. OpenImageIO may explain itself over
// several lines; the first says what happened.
char *fault_words(const std::string &fault)
{
    return fault.empty() ? nullptr : ::strndup(fault.c_str(), fault.find('\n'));
}

// Call a function that returns a fault, and let no exception out.
template <typename Function> char *guarded(Function function)
{
    try {
        return fault_words(function());
    } catch (const std::exception &exception) {
        return fault_words(exception.what());
    } catch (...) {
        return fault_words("unknown fault in OpenImageIO");
    }
}

char *encode_for_c(const Image *image, const char *format, unsigned char **bytes, size_t *n_bytes)
{
    return guarded([&] {
        std::vector<unsigned char> encoded;
        std::string fault = encode(image, format, &encoded);
        if (fault.empty()) {
            *n_bytes = encoded.size();
            *bytes = (unsigned char *)allocate(encoded.size(), 1);
            std::memcpy(*bytes, encoded.data(), encoded.size());
        }
        return fault;
    });
}

char *decode_for_c(const char *path, Image *image)
{
    return guarded([&] { return decode(path, image); });
}

}  // namespace

extern "C" const ImageCodec image_codec = {encode_for_c, decode_for_c};
