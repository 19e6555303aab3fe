// Judging lab 00's three host functions, each by what the probe's own kernels and images saw of it.
// See judge_00.h.
#include "judge_00.h"

#include "cl_check.h"
#include "jobs.h"
#include "message.h"

#include <math.h>
#include <stdlib.h>

// ---- set_arguments ------------------------------------------------------------------------------

// Why a launch with these arguments is refused, "" when that is not known.
static const char *explain_refusal(i32 error)
{
    return error == CL_INVALID_KERNEL_ARGS
               ? "; not each of its three parameters has an argument: one call for each, from 0 on"
           : error == CL_INVALID_MEM_OBJECT
               ? "; the third argument is no image: OpenCL wants the address of d_image"
               : "";
}

// What wrong sizes suggest, "" when nothing.
static const char *explain_sizes(double found_width, double found_height, int width, int height)
{
    return found_width == height && found_height == width    ? "; height comes before width"
           : found_width == width && found_height == width   ? "; width is there twice"
           : found_width == height && found_height == height ? "; height is there twice"
                                                             : "";
}

// NULL when all three arguments arrived in a kernel.
static char *arguments_fault(const JobPicture *gradient, const ArgumentsAnswer *found)
{
    const int width = gradient->expected.reference.width;
    const int height = gradient->expected.reference.height;
    const float *arrived = found->arrived;
    const float wanted[IMAGE_CHANNELS] = {(float)width, (float)height, 0, 1};
    if (found->error != CL_SUCCESS) {
        return message_new("%s: launching a kernel with these arguments: found %s (%d), expected "
                           "CL_SUCCESS%s",
                           gradient->title, cl_error_name(found->error), found->error,
                           explain_refusal(found->error));
    }
    if (is_same_color(arrived, wanted, 0)) {
        return NULL;
    }
    if (arrived[2] != wanted[2] || arrived[3] != wanted[3]) {
        return message_new("%s: a kernel with these arguments ran and wrote into its image: found "
                           "nothing in d_image, expected a colour; it was given another image",
                           gradient->title);
    }
    return message_new("%s: found width %g and height %g in the kernel, expected %d and %d%s",
                       gradient->title, arrived[0], arrived[1], width, height,
                       explain_sizes(arrived[0], arrived[1], width, height));
}

Verdict judge_00_arguments(const void *pointer, int k, const Sections *answers)
{
    const Job00 *job = pointer;
    const ArgumentsAnswer *found = job_section_find(answers, "arguments", k, sizeof *found);
    return found ? verdict_of(arguments_fault(&job->gradients[k], found)) : verdict_missing;
}

// ---- enqueue_pixels -----------------------------------------------------------------------------

// NULL when each pixel has one work-item.
static char *pixels_fault(const JobPicture *gradient, const u32 *n_items)
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
    const u32 n = n_items[first / width * side + first % width];
    return n_wrong == 0
               ? NULL
               : message_new("%s: pixel (%d, %d): found %u work-items, expected 1 (so in %d of %d "
                             "pixels)%s",
                             gradient->title, first % width, first / width, n, n_wrong,
                             width * height, n == 0 ? ": nobody wrote it" : "");
}

// The same for those that stand elsewhere, and for how they are grouped.
static char *groups_fault(const JobPicture *gradient, const u32 *rest)
{
    if (rest[ITEMS_FAR] != 0) {
        return message_new("%s: %u work-items stand more than one group beyond the picture, "
                           "expected none: is the size rounded up to the next multiple of the "
                           "group's?",
                           gradient->title, rest[ITEMS_FAR]);
    }
    if (rest[ITEMS_IN_OTHER_GROUPS] != 0) {
        return message_new("%s: found %u work-items in other work-groups, one of %u x %u, expected "
                           "all in groups of 16 x 16: the local size is GROUP_SIZE in both "
                           "directions",
                           gradient->title, rest[ITEMS_IN_OTHER_GROUPS], rest[ITEMS_GROUP_WIDTH],
                           rest[ITEMS_GROUP_HEIGHT]);
    }
    return NULL;
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
    char *fault = pixels_fault(gradient, n_items);
    return verdict_of(fault ? fault : groups_fault(gradient, n_items + n_places));
}

// ---- read_back ----------------------------------------------------------------------------------

// NULL when the pattern arrived, compared like a picture without a margin.
static char *pattern_fault(const ExpectedPicture *pattern, ProbeImage own)
{
    const int x = own.image_width - 1, y = own.image_height - 1;
    const float *wanted = image_pixel(&pattern->reference, x, y);
    // The array was all NaN; one left in the last pixel says that the copy stopped early.
    if (isnan(probe_image_pixel(own, x, y)[IMAGE_CHANNELS - 1])) {
        return message_new("the array on the host was not filled to its end: nobody wrote pixel "
                           "(%d, %d): found it untouched, expected (%.4g, %.4g, %.4g, %.4g)",
                           x, y, wanted[0], wanted[1], wanted[2], wanted[3]);
    }
    return picture_judge(own, pattern);
}

// NULL when nothing was written behind the picture's last float.
static char *guard_fault(const float *guard)
{
    for (int i = 0; i < READ_BACK_GUARD; i++) {
        if (guard[i] != UNWRITTEN) {
            return message_new("float %d behind the end of h_pixels: found %.9g written there, "
                               "expected nothing; h_pixels has room for the picture only",
                               i, guard[i]);
        }
    }
    return NULL;
}

Verdict judge_00_read_back(const void *pointer, int k, const Sections *answers)
{
    const ExpectedPicture *pattern = &((const Job00 *)pointer)->patterns[k];
    const int width = pattern->reference.width, height = pattern->reference.height;
    const size_t n_floats = (size_t)width * (size_t)height * IMAGE_CHANNELS;
    const size_t n_bytes = (n_floats + READ_BACK_GUARD) * sizeof(float);
    const ProbeImage own = {job_section_find(answers, "readback", k, n_bytes), width, height};
    if (own.pixels == NULL) {
        return verdict_missing;
    }
    char *fault = pattern_fault(pattern, own);
    fault = fault ? fault : guard_fault(own.pixels + n_floats);
    char *message =
        fault ? message_new("an image of %dx%d random colours, read back: %s", width, height, fault)
              : NULL;
    free(fault);
    return verdict_of(message);
}
