// Pictures in memory and in files (see image.h): the one C++ file, around OpenImageIO.
//
// Flow: scene -> buffers -> kernel -> IMAGE -> COMPARISON. Every function that C calls catches
// every exception: one that reached C code would end the program without a message.
// Read next: image.c, where pictures are made and judged.
#include "image.h"

#include "complain.h"
#include "output_file.h"
#include "text_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace
{

int report(const char *path, const std::string &fault)
{
    // OpenImageIO may explain itself over several lines; the first says what happened.
    std::string first_line = fault.substr(0, fault.find('\n'));
    complain("%s: %s", path, first_line.c_str());
    return -1;
}

// Three bytes a pixel. Colours are premultiplied by alpha, so over black they are what they are.
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

int load(const char *path, Image *image)
{
    // OpenImageIO would wait for a pipe's writer, so the file is opened once before.
    FILE *file = text_file_open(path);
    if (file == NULL) {
        return -1;
    }
    std::fclose(file);
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
    if (!input) {
        return report(path, "cannot be read: " + OIIO::geterror());
    }
    const OIIO::ImageSpec spec = input->spec();
    if (spec.depth > 1 || spec.deep || spec.nchannels < 1) {
        return report(path, "not a flat picture");
    }

    int n_channels = std::min(spec.nchannels, IMAGE_CHANNELS);
    if (image_create(spec.width, spec.height, image) != 0) {
        return -1;
    }
    std::vector<float> values((size_t)spec.width * (size_t)spec.height * (size_t)n_channels);
    if (!input->read_image(0, 0, 0, n_channels, OIIO::TypeDesc::FLOAT, values.data())) {
        return report(path, "cannot be read: " + input->geterror());
    }
    spread_channels(values, n_channels, image);
    return 0;
}

}  // namespace

extern "C" int image_save(const Image *image, const char *path)
{
    size_t stem_length = image_stem_length(path);
    if (stem_length == 0) {
        return report(path, "expected a file that ends in .exr or .png");
    }
    const char *format = path + stem_length + 1;  // behind the point: "exr" or "png"

    std::vector<unsigned char> bytes;
    std::string fault;
    try {
        fault = encode(image, format, &bytes);
    } catch (const std::exception &exception) {
        fault = exception.what();
    } catch (...) {
        fault = "unknown fault in OpenImageIO";
    }
    if (!fault.empty()) {
        return report(path, fault);
    }

    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    // What fails in here marks the stream, and output_file_commit() reports it.
    std::fwrite(bytes.data(), 1, bytes.size(), output.file);
    return output_file_commit(&output);
}

extern "C" int image_load(const char *path, Image *image)
{
    *image = Image{};
    int result = -1;
    try {
        result = load(path, image);
    } catch (const std::exception &exception) {
        report(path, exception.what());
    } catch (...) {
        report(path, "unknown fault in OpenImageIO");
    }
    if (result != 0) {
        image_free(image);
    }
    return result;
}
