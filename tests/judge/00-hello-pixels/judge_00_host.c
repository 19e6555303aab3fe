// Judging lab 00's set_arguments and read_back, each by what the probe's own kernel or image saw of
// it. See judge_00.h.
#include "judge_00.h"

#include "cl_check.h"
#include "jobs_00.h"
#include "message.h"
#include "words.h"

#include <math.h>
#include <string.h>

// ---- set_arguments ------------------------------------------------------------------------------

// Why a launch with these arguments is refused.
static Cause explain_refusal(i32 error)
{
    const char *says =
        error == CL_INVALID_KERNEL_ARGS
            ? "not each of its three parameters has an argument: one call for each, from 0 on"
        : error == CL_INVALID_MEM_OBJECT
            ? "the third argument is no image: OpenCL wants the address of d_image"
            : NULL;
    return (Cause){.says = says};
}

// The bits of a float as what they are for an int parameter.
static float bits_of_float(int value)
{
    const float number = (float)value;
    i32 bits;
    memcpy(&bits, &number, sizeof bits);
    return (float)bits;
}

static int is_size(const float *found, double width, double height)
{
    return found[0] == width && found[1] == height;
}

// Is it the size of a picture before number k?
static int is_earlier_size(const Job00 *job, int k, const float *found)
{
    for (int i = 0; i < k; i++) {
        const Image *reference = &job->gradients[i].expected.reference;
        if (is_size(found, reference->width, reference->height)) {
            return 1;
        }
    }
    return 0;
}

// What wrong sizes suggest.
static Cause explain_sizes(const Job00 *job, int k, const float *found)
{
    const int width = job->gradients[k].expected.reference.width;
    const int height = job->gradients[k].expected.reference.height;
    const char *says =
        is_size(found, height, width)    ? "height comes before width"
        : is_size(found, width, width)   ? "width is there twice"
        : is_size(found, height, height) ? "height is there twice"
        : is_size(found, bits_of_float(width), bits_of_float(height))
            ? "these are the bits of two float values: the parameters are of type int"
        : is_size(found, side_in_groups(width), side_in_groups(height))
            ? "these are the sizes that are rounded up for the launch: the kernel needs the "
              "picture's"
        : is_earlier_size(job, k, found)
            ? "these are the sizes of an earlier call: each call has its own"
            : NULL;
    return (Cause){.says = says};
}

// Did all three arguments arrive in a kernel?
static Diagnosis arguments_fault(const Job00 *job, int k, const ArgumentsAnswer *found)
{
    const JobPicture *gradient = &job->gradients[k];
    const int width = gradient->expected.reference.width;
    const int height = gradient->expected.reference.height;
    const float *arrived = found->arrived;
    const float wanted[IMAGE_CHANNELS] = {(float)width, (float)height, 0, 1};
    if (found->error != CL_SUCCESS) {
        return diagnosis_of(message_new("%s: launching a kernel with these arguments: found %s "
                                        "(%d), expected CL_SUCCESS",
                                        gradient->title, cl_error_name(found->error), found->error),
                            explain_refusal(found->error));
    }
    if (is_same_color(arrived, wanted, 0)) {
        return NOTHING_WRONG;
    }
    if (arrived[2] != wanted[2] || arrived[3] != wanted[3]) {
        return diagnosis_of(message_new("%s: a kernel with these arguments ran and wrote into its "
                                        "image: found nothing in d_image, expected a colour",
                                        gradient->title),
                            (Cause){.says = "it was given another image"});
    }
    return diagnosis_of(
        message_new("%s: found width %g and height %g in the kernel, expected %d and %d",
                    gradient->title, arrived[0], arrived[1], width, height),
        explain_sizes(job, k, arrived));
}

Verdict judge_00_arguments(const void *pointer, int k, const Sections *answers)
{
    const Job00 *job = pointer;
    const ArgumentsAnswer *found = job_section_find(answers, "arguments", k, sizeof *found);
    return found ? verdict_of(arguments_fault(job, k, found)) : verdict_missing;
}

// ---- read_back ----------------------------------------------------------------------------------

// Do rows lie in the array as with a row pitch of `pitch` bytes? What comes later covers what is
// there already; what nobody wrote is NaN.
static int is_pitched(const ExpectedPicture *pattern, const float *found, size_t pitch)
{
    const size_t row = (size_t)pattern->reference.width * IMAGE_CHANNELS;
    const size_t n_rows = (size_t)pattern->reference.height, step = pitch / sizeof(float);
    int is_same = 1;
    for (size_t i = 0; is_same && i < row * n_rows; i++) {
        const size_t last = i / step < n_rows ? i / step : n_rows - 1;
        const int is_row = i - last * step < row;
        is_same = is_row ? found[i] == pattern->reference.pixels[last * row + i - last * step]
                         : isnan(found[i]);
    }
    return is_same;
}

// What an array that is not filled, or filled otherwise, suggests.
static const char *explain_read(const ExpectedPicture *pattern, const float *found, int is_late)
{
    const size_t width = (size_t)pattern->reference.width;
    const size_t row_in_groups =
        (size_t)side_in_groups((int)width) * IMAGE_CHANNELS * sizeof(float);
    return is_late ? "it arrived after read_back had returned: nobody waited for it"
           : is_pitched(pattern, found, width * IMAGE_CHANNELS)
               ? "the row pitch counts bytes, not floats; 0 means no gaps"
           : is_pitched(pattern, found, row_in_groups)
               ? "the row pitch is that of a width rounded up: in h_pixels rows have no gaps"
               : NULL;
}

// Did the pattern arrive? Compared like a picture without a margin.
//   is_late   more of it arrived when read_back had returned
static Diagnosis pattern_fault(const ExpectedPicture *pattern, ProbeImage own, int is_late)
{
    const int x = own.image_width - 1, y = own.image_height - 1;
    const float *wanted = image_pixel(&pattern->reference, x, y);
    const char *says = explain_read(pattern, own.pixels, is_late);
    // The array was all NaN; one left in the last pixel says that the copy stopped early.
    if (isnan(probe_image_pixel(own, x, y)[IMAGE_CHANNELS - 1])) {
        const int is_row = !isnan(own.pixels[0]) && y > 0 &&
                           isnan(probe_image_pixel(own, 0, y)[0]) &&
                           !isnan(probe_image_pixel(own, x, y - 1)[IMAGE_CHANNELS - 1]);
        return diagnosis_of(
            message_new("the array on the host was not filled to its end: nobody "
                        "wrote pixel (%d, %d): found it untouched, expected (%.4g, "
                        "%.4g, %.4g, %.4g)",
                        x, y, wanted[0], wanted[1], wanted[2], wanted[3]),
            (Cause){.says = says == NULL && is_row ? "the last row is missing" : says,
                    .mistake = MISTAKE_UNWRITTEN});
    }
    Diagnosis wrong = picture_judge(own, pattern);
    if (wrong.found != NULL && says != NULL) {
        char *found = wrong.found;
        wrong.found = NULL;
        diagnosis_free(&wrong);
        wrong = diagnosis_of(found, (Cause){.says = says});
    }
    return wrong;
}

// Was something written behind the picture's last float?
static Diagnosis guard_fault(const float *guard)
{
    for (int i = 0; i < READ_BACK_GUARD; i++) {
        if (guard[i] != UNWRITTEN) {
            return diagnosis_of(
                message_new("float %d behind the end of h_pixels: found %.9g written "
                            "there, expected nothing",
                            i, guard[i]),
                (Cause){.says = "h_pixels has room for the picture only"});
        }
    }
    return NOTHING_WRONG;
}

Verdict judge_00_read_back(const void *pointer, int k, const Sections *answers)
{
    const ExpectedPicture *pattern = &((const Job00 *)pointer)->patterns[k];
    const int width = pattern->reference.width, height = pattern->reference.height;
    const size_t n_floats = (size_t)width * (size_t)height * IMAGE_CHANNELS;
    const size_t n_bytes = (n_floats + N_READ_BACK_REST) * sizeof(float);
    const ProbeImage own = {job_section_find(answers, "readback", k, n_bytes), width, height};
    if (own.pixels == NULL) {
        return verdict_missing;
    }
    const int is_late = own.pixels[n_floats + READ_BACK_LATE] != 0;
    Diagnosis fault = pattern_fault(pattern, own, is_late);
    fault = fault.found != NULL ? fault : guard_fault(own.pixels + n_floats);
    const Words where = words("an image of %dx%d random colours, read back", width, height);
    return verdict_of(diagnosis_at(where.text, fault));
}
