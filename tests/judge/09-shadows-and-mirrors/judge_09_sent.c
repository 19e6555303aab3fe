// Lab 09: how many rays are sent for a pixel. A ray whose light is not added shows in no picture.
//
// In these scenes the tree is one leaf: every ray visits it once, so that the leaves visited are
// the rays sent, and no rounding has a part in it. What the oracle calls ambiguous is left out.
#include "judge_09.h"

#include "job_work.h"
#include "message.h"
#include "words.h"

// First one in which rays end at surfaces and beyond them, after no mirror, one and two: there
// mistakes can be told apart.
static const int sent_scenes[N_SENT_SCENES] = {
    BACKGROUNDS,  // random spheres, two mirrors
    LOCAL,        // whose tree is also lit_color's
    ENDS - 2,     // a room
    ENDS + 6,     // one where weights fall below LEAST_WEIGHT
};

int sent_09_is_counted(int k)
{
    int i = 0;
    while (i < N_SENT_SCENES && sent_scenes[i] != k) {
        i++;
    }
    return i < N_SENT_SCENES;
}

// ---- One pixel ----------------------------------------------------------------------------------

typedef struct Sent {
    OracleRayCount expected;
    u32 found;
    int is_judged;  // does rounding decide nothing on the way?
} Sent;

static u32 all_sent(const OracleRayCount *expected)
{
    return expected->n_traced + expected->n_to_lights;
}

static u32 most_of(const Sent *sent)
{
    return all_sent(&sent->expected);
}

static Sent sent_at(const MirrorScene *scene, int pixel, const Work *found,
                    const OracleMirrorRules *rules)
{
    const OracleRay ray = job_scene3d_ray(&scene->base, pixel);
    Sent sent = {.found = found[pixel].n_leaves_visited};
    const OracleNear color =
        oracle3d_follow(&scene->base.scene, ray, scene->max_bounces, rules, &sent.expected);
    sent.is_judged = !isinf(color.error);
    if (rules->stubs) {
        // lit_color's sends none, and counts a leaf instead.
        sent.expected.n_to_lights = sent.expected.n_hits;
    }
    return sent;
}

// Rays to lights may be fewer, as nothing comes of one where kd is 0; but none are too few where
// something does: no light and no surface of the scenes is black.
static u32 least_of(const Sent *sent)
{
    return sent->expected.n_traced + (sent->expected.n_needed > 0 ? 1 : 0);
}

// Too many rays are work for nothing. Fewer do not follow the mirrors, or are counted elsewhere.
static int is_right(const Sent *sent)
{
    return !sent->is_judged || (sent->found >= least_of(sent) && sent->found <= most_of(sent));
}

// ---- Known mistakes -----------------------------------------------------------------------------

// What a mistake makes of a pixel's rays.
typedef u32 MistakenCount(const OracleRayCount *expected);

// Where the last ray hits something, the end is not that nothing is hit.
static u32 traced_beyond_end(const OracleRayCount *expected)
{
    return expected->n_traced + expected->n_to_lights +
           (expected->n_hits == expected->n_traced ? 1 : 0);
}

static u32 lit_twice(const OracleRayCount *expected)
{
    return expected->n_traced + 2 * expected->n_to_lights;
}

static u32 only_traced(const OracleRayCount *expected)
{
    return expected->n_traced;
}

static u32 only_to_lights(const OracleRayCount *expected)
{
    return expected->n_to_lights;
}

static u32 none(const OracleRayCount *expected)
{
    (void)expected;
    return 0;
}

static const struct {
    Cause cause;
    MistakenCount *count;
    OracleMirrorRules rules;  // of the rays that are sent
    int needs_picture;        // only a right picture tells that rays were sent without `work`
} mistakes[] = {
    {.cause.says = "no ray to a light is counted, and the light is there: `work` was not passed on "
                   "to lit_color",
     .count = only_traced,
     .needs_picture = 1},
    {.cause.says = "no ray that is traced is counted, and what it hits is there: `work` was not "
                   "passed on to trace",
     .count = only_to_lights,
     .needs_picture = 1},
    {.cause.says = "no ray is counted, and the picture is right: `work` was not passed on, neither "
                   "to trace nor to lit_color",
     .count = none,
     .needs_picture = 1},
    {.cause.says = "the last rays are not sent: with N mirrors at most N + 1 hits count",
     .count = all_sent,
     .rules.more_bounces = -1},
    {.cause.says = "no ray to a light is counted: lit_color is not called, or not with `work`",
     .count = only_traced},
    {.cause.says = "no ray is counted: trace is not called, or not with `work`", .count = none},
    {.cause.says = "one ray more is traced where the end is reached, and what it hits adds "
                   "nothing: whether it goes on is asked first",
     .count = traced_beyond_end},
    {.cause.says = "for every hit all lights are asked twice: lit_color is needed once",
     .count = lit_twice},
};

// Does a mistake explain how many rays every pixel of the scene sends?
static int explains(int m, const MirrorScene *scene, const Work *found)
{
    const int n_pixels = scene->base.scene.width * scene->base.scene.height;
    int pixel = 0, fits = 1;
    while (fits && pixel < n_pixels) {
        const Sent sent = sent_at(scene, pixel++, found, &mistakes[m].rules);
        fits = !sent.is_judged || sent.expected.n_unsure > 0 ||
               sent.found == mistakes[m].count(&sent.expected);
    }
    return fits;
}

static Cause explain(const void *job, int k, const Sections *answers)
{
    const MirrorScene *scene = &((const Job09 *)job)->scenes[k];
    const Work *found = job_work_find(&scene->base.picture, k, answers);
    const int is_picture = verdict_passes(judge_picture(job, k, answers));
    int m = 0;
    while (m < COUNT(mistakes) &&
           !((is_picture || !mistakes[m].needs_picture) && explains(m, scene, found))) {
        m++;
    }
    return m < COUNT(mistakes) ? mistakes[m].cause : (Cause){0};
}

// ---- Judging ------------------------------------------------------------------------------------

static Diagnosis judge_scene(const void *job, int k, const Sections *answers)
{
    static const OracleMirrorRules right = {0};
    const MirrorScene *scene = &((const Job09 *)job)->scenes[k];
    const Work *found = job_work_find(&scene->base.picture, k, answers);
    const int width = scene->base.scene.width, n_pixels = width * scene->base.scene.height;
    int n_wrong = 0, first_pixel = 0;
    Sent first = {0};
    for (int pixel = n_pixels - 1; pixel >= 0; pixel--) {
        const Sent sent = sent_at(scene, pixel, found, &right);
        if (!is_right(&sent)) {
            n_wrong++;
            first = sent, first_pixel = pixel;
        }
    }
    if (n_wrong == 0) {
        return NOTHING_WRONG;
    }
    const char *title = scene->base.picture.title;
    const int x = first_pixel % width, y = first_pixel / width;
    if (first.found < least_of(&first)) {
        char *few = message_new(
            "%s: pixel (%d, %d): found %u ray%s sent, expected at least %u: %u that %s traced%s "
            "(%d of %d pixels are wrong)",
            title, x, y, first.found, plural(first.found), least_of(&first),
            first.expected.n_traced, first.expected.n_traced == 1 ? "is" : "are",
            first.expected.n_needed > 0 ? " and one to a light" : "", n_wrong, n_pixels);
        return diagnosis_of(few, explain(job, k, answers));
    }
    char *wrong = message_new(
        "%s: pixel (%d, %d): found %u rays sent, expected at most %u: %u that %s traced and %u to "
        "lights (%d of %d pixels send more than they need)",
        title, x, y, first.found, most_of(&first), first.expected.n_traced,
        first.expected.n_traced == 1 ? "is" : "are", first.expected.n_to_lights, n_wrong, n_pixels);
    return diagnosis_of(wrong, explain(job, k, answers));
}

Verdict judge_sent_09(const void *pointer, int i, const Sections *answers)
{
    const int k = sent_scenes[i];
    const MirrorScene *scene = &((const Job09 *)pointer)->scenes[k];
    return job_work_find(&scene->base.picture, k, answers) == NULL
               ? verdict_missing
               : verdict_of(judge_scene(pointer, k, answers));
}

int sent_alone_09(const void *pointer, int i, const Sections *answers)
{
    const Job09 *job = pointer;
    const int k = sent_scenes[i];
    const MirrorScene *scene = &job->scenes[k];
    const OracleMirrorRules rules = {
        .stubs = 1, .turn = TURN_ALONG_NORMAL, .nonce = job->job.nonce};
    const Work *found = job_work_find(&scene->base.picture, k, answers);
    const int n_pixels = scene->base.scene.width * scene->base.scene.height;
    int pixel = 0;
    while (found != NULL && pixel < n_pixels) {
        const Sent sent = sent_at(scene, pixel, found, &rules);
        if (!is_right(&sent)) {
            break;
        }
        pixel++;
    }
    return pixel == n_pixels;
}
