// Judging lab 00's three host functions, each by what the probe's own kernels and images saw of it.
// See judge_00.h.
#include "judge_00.h"

#include "cl_check.h"
#include "jobs.h"
#include "message.h"
#include "words.h"

#include <math.h>

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

// What wrong sizes suggest.
static Cause explain_sizes(double found_width, double found_height, int width, int height)
{
    const char *says = found_width == height && found_height == width  ? "height comes before width"
                       : found_width == width && found_height == width ? "width is there twice"
                       : found_width == height && found_height == height ? "height is there twice"
                                                                         : NULL;
    return (Cause){.says = says};
}

// Did all three arguments arrive in a kernel?
static Diagnosis arguments_fault(const JobPicture *gradient, const ArgumentsAnswer *found)
{
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
        explain_sizes(arrived[0], arrived[1], width, height));
}

Verdict judge_00_arguments(const void *pointer, int k, const Sections *answers)
{
    const Job00 *job = pointer;
    const ArgumentsAnswer *found = job_section_find(answers, "arguments", k, sizeof *found);
    return found ? verdict_of(arguments_fault(&job->gradients[k], found)) : verdict_missing;
}

// ---- enqueue_pixels -----------------------------------------------------------------------------

// Has each pixel one work-item?
static Diagnosis pixels_fault(const JobPicture *gradient, const u32 *n_items)
{
    const int width = gradient->expected.reference.width;
    const int height = gradient->expected.reference.height;
    const int side = PROBE_IMAGE_SIDE(width);
    int n_wrong = 0, first = 0;
    for (int i = width * height - 1; i >= 0; i--) {
        if (n_items[i / width * side + i % width] != 1) {
            n_wrong++;
            first = i;
        }
    }
    if (n_wrong == 0) {
        return NOTHING_WRONG;
    }
    const u32 n = n_items[first / width * side + first % width];
    return diagnosis_of(
        message_new("%s: pixel (%d, %d): found %u work-items, expected 1 (so in %d of %d pixels)%s",
                    gradient->title, first % width, first / width, n, n_wrong, width * height,
                    n == 0 ? ": nobody wrote it" : ""),
        (Cause){.mistake = n == 0 ? MISTAKE_UNWRITTEN : MISTAKE_NONE});
}

// The same for those that stand elsewhere, and for how they are grouped.
static Diagnosis groups_fault(const JobPicture *gradient, const u32 *rest)
{
    if (rest[ITEMS_FAR] != 0) {
        return diagnosis_new("%s: %u work-items stand more than one group beyond the picture, "
                             "expected none: is the size rounded up to the next multiple of the "
                             "group's?",
                             gradient->title, rest[ITEMS_FAR]);
    }
    if (rest[ITEMS_IN_OTHER_GROUPS] != 0) {
        return diagnosis_new(
            "%s: found %u work-items in other work-groups, one of %u x %u, expected "
            "all in groups of 16 x 16: the local size is GROUP_SIZE in both "
            "directions",
            gradient->title, rest[ITEMS_IN_OTHER_GROUPS], rest[ITEMS_GROUP_WIDTH],
            rest[ITEMS_GROUP_HEIGHT]);
    }
    return NOTHING_WRONG;
}

Verdict judge_00_items(const void *pointer, int k, const Sections *answers)
{
    const JobPicture *gradient = &((const Job00 *)pointer)->gradients[k];
    const Image *reference = &gradient->expected.reference;
    const size_t n_places =
        (size_t)PROBE_IMAGE_SIDE(reference->width) * (size_t)PROBE_IMAGE_SIDE(reference->height);
    const u32 *n_items =
        job_section_find(answers, "items", k, (n_places + N_ITEMS_REST) * sizeof *n_items);
    if (n_items == NULL) {
        return verdict_missing;
    }
    const Diagnosis fault = pixels_fault(gradient, n_items);
    return verdict_of(fault.found != NULL ? fault : groups_fault(gradient, n_items + n_places));
}

// ---- read_back ----------------------------------------------------------------------------------

// Did the pattern arrive? Compared like a picture without a margin.
static Diagnosis pattern_fault(const ExpectedPicture *pattern, ProbeImage own)
{
    const int x = own.image_width - 1, y = own.image_height - 1;
    const float *wanted = image_pixel(&pattern->reference, x, y);
    // The array was all NaN; one left in the last pixel says that the copy stopped early.
    if (isnan(probe_image_pixel(own, x, y)[IMAGE_CHANNELS - 1])) {
        return diagnosis_of(message_new("the array on the host was not filled to its end: nobody "
                                        "wrote pixel (%d, %d): found it untouched, expected (%.4g, "
                                        "%.4g, %.4g, %.4g)",
                                        x, y, wanted[0], wanted[1], wanted[2], wanted[3]),
                            (Cause){.mistake = MISTAKE_UNWRITTEN});
    }
    return picture_judge(own, pattern);
}

Verdict judge_00_read_back(const void *pointer, int k, const Sections *answers)
{
    const ExpectedPicture *pattern = &((const Job00 *)pointer)->patterns[k];
    const int width = pattern->reference.width, height = pattern->reference.height;
    const size_t n_bytes = (size_t)width * (size_t)height * IMAGE_CHANNELS * sizeof(float);
    const ProbeImage own = {job_section_find(answers, "readback", k, n_bytes), width, height};
    if (own.pixels == NULL) {
        return verdict_missing;
    }
    const Words where = words("an image of %dx%d random colours, read back", width, height);
    return verdict_of(diagnosis_at(where.text, pattern_fault(pattern, own)));
}
