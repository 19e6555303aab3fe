// Pictures of a job: found among the answers, judged, shown.
#include "job_picture.h"

#include "job_sections.h"
#include "jobs.h"

ProbeImage job_picture_answer(const JobPicture *picture, int k, const Sections *answers)
{
    const Image *reference = &picture->expected.reference;
    return probe_image_find(answers, k, reference->width, reference->height);
}

// An answer of another size than the probe writes: NULL when there is none at all, or two.
static Diagnosis describe_size(const JobPicture *picture, int k, const Sections *answers)
{
    char name[SECTION_NAME_BYTES];
    size_t n_found;
    snprintf(name, sizeof name, "picture.%d", k);
    if (sections_find_any(answers, name, &n_found) == NULL) {
        return NOTHING_WRONG;
    }
    const Image *reference = &picture->expected.reference;
    const size_t n_pixels =
        (size_t)PROBE_IMAGE_SIDE(reference->width) * (size_t)PROBE_IMAGE_SIDE(reference->height);
    const size_t pixel_bytes = IMAGE_CHANNELS * sizeof(float);
    const size_t n_channels = n_found / (n_pixels * sizeof(float));
    if (n_channels > 0 && n_found == n_channels * n_pixels * sizeof(float)) {
        return diagnosis_new("%s: found a picture of %zu channels, expected %d", picture->title,
                             n_channels, IMAGE_CHANNELS);
    }
    return diagnosis_new(
        "%s: found a picture of another size: %zu bytes, expected %zu pixels of %zu",
        picture->title, n_found, n_pixels, pixel_bytes);
}

Verdict job_picture_judge(const JobPicture *picture, int k, const Sections *answers)
{
    const ProbeImage own = job_picture_answer(picture, k, answers);
    if (own.pixels == NULL) {
        const Diagnosis size = describe_size(picture, k, answers);
        return size.found != NULL ? verdict_of(size) : verdict_missing;
    }
    return verdict_of(diagnosis_at(picture->title, picture_judge(own, &picture->expected)));
}

Verdict job_picture_judge_padding(const JobPicture *picture, int k, const Sections *answers)
{
    const ProbeImage own = job_picture_answer(picture, k, answers);
    if (own.pixels == NULL) {
        return verdict_missing;
    }
    const Diagnosis outside = picture_judge_padding(own, &picture->expected);
    // Drawing too little is no way to keep inside the picture.
    return verdict_of(outside.found != NULL ? outside
                                            : picture_judge_written(own, &picture->expected));
}

void job_picture_adopt(JobPicture *picture, int k, const Sections *answers)
{
    Image *reference = &picture->expected.reference, drawn;
    const ProbeImage own = job_picture_answer(picture, k, answers);
    if (picture_copy(own, reference->width, reference->height, &drawn) == 0) {
        image_free(reference);
        *reference = drawn;
    }
}

static void report_one(const JobPicture *job_picture, int k, const Sections *answers,
                       Result *result)
{
    if (result->n_pictures == RESULT_MAX_PICTURES) {
        return;
    }
    PictureResult *picture = &result->pictures[result->n_pictures++];
    const ProbeImage own = job_picture_answer(job_picture, k, answers);
    const Image *reference = &job_picture->expected.reference;
    snprintf(picture->title, sizeof picture->title, "%s", job_picture->title);
    const ProbeImage wanted = {reference->pixels, reference->width, reference->height};
    picture_copy(wanted, reference->width, reference->height, &picture->reference);
    if (own.pixels != NULL) {
        picture_copy(own, reference->width, reference->height, &picture->own);
    }
}

void job_pictures_report(const JobPicture *first, size_t step, int n, const Sections *answers,
                         Result *result)
{
    // Enough to see what is wrong; a page of all of them would only be slower.
    enum { MAX_WRONG = 6, MAX_RIGHT = 3 };
    for (int want_wrong = 1; want_wrong >= 0; want_wrong--) {
        int n_added = 0;
        for (int k = 0; k < n && n_added < (want_wrong ? MAX_WRONG : MAX_RIGHT); k++) {
            const JobPicture *picture = (const void *)((const char *)first + (size_t)k * step);
            const ProbeImage own = job_picture_answer(picture, k, answers);
            const int is_wrong = own.pixels == NULL || !picture_is_right(own, &picture->expected);
            if (is_wrong == want_wrong) {
                report_one(picture, k, answers, result);
                n_added++;
            }
        }
    }
}
