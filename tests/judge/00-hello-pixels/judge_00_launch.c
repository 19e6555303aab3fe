// Judging lab 00's enqueue_pixels by the work-items that a kernel of the probe counted. See
// judge_00.h.
#include "judge_00.h"

#include "jobs_00.h"
#include "message.h"

// The launch of a known mistake: how many work-items in each direction for picture k.
typedef struct Launch {
    int width, height;
} Launch;
typedef Launch Rival(const Job00 *job, int k);

static Launch picture_size(const Job00 *job, int k)
{
    const Image *reference = &job->gradients[k].expected.reference;
    return (Launch){reference->width, reference->height};
}

static Launch in_groups(int width, int height)
{
    return (Launch){side_in_groups(width), side_in_groups(height)};
}

static int rounded_down(int side)
{
    return side / GROUP_SIDE * GROUP_SIDE;
}

static Launch both_down(const Job00 *job, int k)
{
    const Launch size = picture_size(job, k);
    return (Launch){rounded_down(size.width), rounded_down(size.height)};
}

static Launch to_the_nearest(const Job00 *job, int k)
{
    const Launch size = picture_size(job, k);
    return (Launch){rounded_down(size.width + GROUP_SIDE / 2),
                    rounded_down(size.height + GROUP_SIDE / 2)};
}

static Launch swapped(const Job00 *job, int k)
{
    const Launch size = picture_size(job, k);
    return in_groups(size.height, size.width);
}

static Launch width_twice(const Job00 *job, int k)
{
    const Launch size = picture_size(job, k);
    return in_groups(size.width, size.width);
}

static Launch height_twice(const Job00 *job, int k)
{
    const Launch size = picture_size(job, k);
    return in_groups(size.height, size.height);
}

static Launch longer_twice(const Job00 *job, int k)
{
    const Launch size = picture_size(job, k);
    return size.width > size.height ? width_twice(job, k) : height_twice(job, k);
}

static Launch first_again(const Job00 *job, int k)
{
    const Launch size = picture_size(job, 0);
    (void)k;
    return in_groups(size.width, size.height);
}

static Launch groups_for_items(const Job00 *job, int k)
{
    const Launch size = picture_size(job, k);
    return (Launch){side_in_groups(size.width) / GROUP_SIDE,
                    side_in_groups(size.height) / GROUP_SIDE};
}

static Launch items_times_group(const Job00 *job, int k)
{
    const Launch size = picture_size(job, k);
    return (Launch){size.width * GROUP_SIDE, size.height * GROUP_SIDE};
}

static Launch one_row(const Job00 *job, int k)
{
    return (Launch){side_in_groups(picture_size(job, k).width), 1};
}

static Launch one_group(const Job00 *job, int k)
{
    (void)job, (void)k;
    return (Launch){GROUP_SIDE, GROUP_SIDE};
}

static const struct {
    Rival *launch;
    const char *says;
} launches[] = {
    {both_down, "the sizes were rounded down, and must be rounded up"},
    {to_the_nearest, "the sizes were rounded to the nearest multiple, so some of them were rounded "
                     "down"},
    {swapped, "width and height are in each other's places"},
    {width_twice, "both global sizes come from width"},
    {height_twice, "both global sizes come from height"},
    {longer_twice, "both global sizes come from the longer side"},
    {first_again, "that is the size of an earlier call: each call has its own"},
    {groups_for_items, "the global size counts work-items, not groups"},
    {items_times_group, "each pixel has one work-item, not a group of them"},
    {one_row, "that is one row of work-items: a picture has two dimensions"},
    {one_group, "that is one group, whatever the picture's size"},
};

// The answer for picture k: how many work-items each place has, and N_ITEMS_REST numbers behind
// them; NULL where it is missing.
static const u32 *items_find(const Job00 *job, int k, const Sections *answers, size_t *n_places)
{
    const Launch size = picture_size(job, k);
    *n_places = (size_t)PROBE_IMAGE_SIDE(size.width) * (size_t)PROBE_IMAGE_SIDE(size.height);
    return job_section_find(answers, "items", k, (*n_places + N_ITEMS_REST) * sizeof(u32));
}

// Were all pictures launched so?
static int is_launch(const Job00 *job, Rival *rival, const Sections *answers)
{
    int is_same = 1;
    for (int k = 0; is_same && k < N_SIZES; k++) {
        const Launch launch = rival(job, k);
        const u32 side = (u32)PROBE_IMAGE_SIDE(picture_size(job, k).width);
        size_t n_places, n_far = (size_t)launch.width * (size_t)launch.height;
        const u32 *n_items = items_find(job, k, answers, &n_places);
        is_same = n_items != NULL;
        for (size_t i = 0; is_same && i < n_places; i++) {
            const u32 expected =
                i % side < (size_t)launch.width && i / side < (size_t)launch.height;
            is_same = n_items[i] == expected;
            n_far -= expected;
        }
        is_same = is_same && n_items[n_places + ITEMS_FAR] == n_far;
    }
    return is_same;
}

static const char *explain_launch(const Job00 *job, const Sections *answers)
{
    for (size_t i = 0; i < sizeof launches / sizeof *launches; i++) {
        if (is_launch(job, launches[i].launch, answers)) {
            return launches[i].says;
        }
    }
    return NULL;
}

// Has each pixel one work-item?
static Diagnosis pixels_fault(const Job00 *job, int k, const Sections *answers, const u32 *n_items)
{
    const Launch size = picture_size(job, k);
    const int n_pixels = size.width * size.height, side = PROBE_IMAGE_SIDE(size.width);
    int n_wrong = 0, first = 0;
    for (int i = n_pixels - 1; i >= 0; i--) {
        if (n_items[i / size.width * side + i % size.width] != 1) {
            n_wrong++;
            first = i;
        }
    }
    if (n_wrong == 0) {
        return NOTHING_WRONG;
    }
    const int x = first % size.width, y = first / size.width;
    const u32 n = n_items[y * side + x];
    const char *says = explain_launch(job, answers);
    return diagnosis_of(
        message_new("%s: pixel (%d, %d): found %u work-item%s, expected 1 (so in %d of %d "
                    "pixels)%s",
                    job->gradients[k].title, x, y, n, plural(n), n_wrong, n_pixels,
                    n == 0 ? ": nobody wrote it" : ""),
        (Cause){.says =
                    says == NULL && n > 1 ? "the same pixels were launched more than once" : says,
                .mistake = n == 0 ? MISTAKE_UNWRITTEN : MISTAKE_NONE});
}

// The same for those that stand elsewhere, and for how they are grouped.
static Diagnosis groups_fault(const Job00 *job, int k, const Sections *answers, const u32 *rest)
{
    const char *says = rest[ITEMS_FAR] != 0 ? explain_launch(job, answers) : NULL;
    // Groups of another shape may need more room: then that is the mistake.
    if (rest[ITEMS_FAR] != 0 && (says != NULL || rest[ITEMS_IN_OTHER_GROUPS] == 0)) {
        return diagnosis_of(
            message_new("%s: found %u work-item%s more than one group beyond the picture, expected "
                        "none",
                        job->gradients[k].title, rest[ITEMS_FAR], plural(rest[ITEMS_FAR])),
            (Cause){.says = says != NULL ? says
                                         : "the size is to be rounded up to the next multiple of "
                                           "the group's, and no further"});
    }
    if (rest[ITEMS_IN_OTHER_GROUPS] != 0) {
        const u32 n = rest[ITEMS_IN_OTHER_GROUPS];
        return diagnosis_of(
            message_new("%s: found %u work-item%s in other work-groups, one of %u x %u, expected "
                        "all in groups of 16 x 16",
                        job->gradients[k].title, n, plural(n), rest[ITEMS_GROUP_WIDTH],
                        rest[ITEMS_GROUP_HEIGHT]),
            (Cause){.says = "the local size is GROUP_SIZE in both directions: NULL leaves it to "
                            "the driver"});
    }
    return NOTHING_WRONG;
}

Verdict judge_00_items(const void *pointer, int k, const Sections *answers)
{
    const Job00 *job = pointer;
    size_t n_places;
    const u32 *n_items = items_find(job, k, answers, &n_places);
    if (n_items == NULL) {
        return verdict_missing;
    }
    const Diagnosis fault = pixels_fault(job, k, answers, n_items);
    return verdict_of(fault.found != NULL ? fault
                                          : groups_fault(job, k, answers, n_items + n_places));
}
