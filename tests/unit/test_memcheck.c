// memcheck_job and advice: arrays end where they end, and the memory sanitizer's job is small; a
// report offers memcheck where it may help.
#include "advice.h"
#include "jobs.h"
#include "judge.h"
#include "memcheck_job.h"
#include "message.h"
#include "surroundings.h"

#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

TestSuite(memcheck);

// ---- The small job ------------------------------------------------------------------------------

static Sections job_made(const Sections *job, int (*write)(const Sections *job, FILE *file))
{
    char *bytes = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&bytes, &n_bytes);
    cr_assert_eq(write(job, file), 0);
    fclose(file);
    return (Sections){(unsigned char *)bytes, n_bytes};
}

// A lab's job, made small.
static Sections small_job(const char *lab)
{
    const Judge *judge = judge_of(lab);
    char *bytes = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&bytes, &n_bytes);
    Job *job = job_new(judge, 1, file);
    fclose(file);
    cr_assert_not_null(job);
    job_free(job);
    const Sections whole = {(unsigned char *)bytes, n_bytes};
    const Sections made = job_made(&whole, memcheck_job_write);
    const Sections small = job_made(&made, memcheck_job_write_small);
    cr_expect_leq(made.n_bytes, whole.n_bytes);
    cr_expect_lt(small.n_bytes, made.n_bytes);
    free(bytes);
    free(made.bytes);
    return small;
}

static const void *scene_part(const Sections *job, int k, const char *part, size_t *n_bytes)
{
    char name[64];
    snprintf(name, sizeof name, part ? "scene.%d.%s" : "scene.%d", k, part);
    return sections_find_any(job, name, n_bytes);
}

static int is_small(int side)
{
    return side >= 1 && side <= 16;
}

Test(memcheck, a_job_of_circles_is_small)
{
    static const char *const labs[] = {"00-hello-pixels", "01-naive-2d", "03-kdtree-2d-render"};
    for (size_t i = 0; i < sizeof labs / sizeof *labs; i++) {
        Sections job = small_job(labs[i]);
        const SceneJob *scene;
        size_t n_bytes;
        int k = 0;
        for (; (scene = scene_part(&job, k, NULL, &n_bytes)) != NULL; k++) {
            cr_assert_eq(n_bytes, sizeof *scene);
            cr_expect(is_small(scene->width) && is_small(scene->height), "%s", labs[i]);
            const Circle *circles = scene_part(&job, k, "circles", &n_bytes);
            if (circles != NULL) {
                cr_expect_eq(n_bytes, (size_t)scene->n_circles * sizeof *circles, "%s", labs[i]);
            }
        }
        cr_expect(k > 1 && k <= 6, "%s: %d scenes", labs[i], k);
        sections_free(&job);
    }
}

// The tree of a scaled scene is the scaled tree: each circle is where its cell is.
Test(memcheck, circles_and_cells_keep_their_places)
{
    Sections job = small_job("03-kdtree-2d-render");
    size_t n_bytes;
    const SceneJob *scene = scene_part(&job, 0, NULL, &n_bytes);
    const Circle *circles = scene_part(&job, 0, "circles", &n_bytes);
    const BBox2D *root = scene_part(&job, 0, "boxes", &n_bytes);
    cr_assert(scene && circles && root);
    for (int i = 0; i < scene->n_circles; i++) {
        const Circle c = circles[i];
        cr_expect(c.x - c.radius >= root->minX && c.x + c.radius <= root->maxX);
        cr_expect(c.y - c.radius >= root->minY && c.y + c.radius <= root->maxY);
    }
    sections_free(&job);
}

Test(memcheck, a_job_of_spheres_is_small)
{
    static const char *const labs[] = {"05-spheres", "07-kdtree-3d-trace"};
    for (size_t i = 0; i < sizeof labs / sizeof *labs; i++) {
        Sections job = small_job(labs[i]);
        const SceneJob3D *scene;
        size_t n_bytes;
        int k = 0;
        for (; (scene = scene_part(&job, k, NULL, &n_bytes)) != NULL; k++) {
            cr_expect(is_small(scene->width) && is_small(scene->height), "%s", labs[i]);
            cr_assert_not_null(scene_part(&job, k, "spheres", &n_bytes));
            cr_expect_eq(n_bytes, (size_t)scene->n_spheres * sizeof(Sphere));
            cr_assert_not_null(scene_part(&job, k, "material_ids", &n_bytes));
            cr_expect_eq(n_bytes, (size_t)scene->n_spheres * sizeof(u32));
            cr_assert_not_null(scene_part(&job, k, "lights", &n_bytes));
            cr_expect_eq(n_bytes, (size_t)scene->n_lights * sizeof(Light));
        }
        cr_expect(k > 1 && k <= 6, "%s: %d scenes", labs[i], k);
        sections_free(&job);
    }
}

// ---- The offer ----------------------------------------------------------------------------------

// What was found in a failed check.
typedef struct Seen {
    Evidence evidence;
    Cause cause;
} Seen;
static const Seen strange = {.evidence = EVIDENCE_PICTURE};  // pixels, and nothing says why
static const Seen values = {.evidence = EVIDENCE_VALUES};

static void see(CheckResult *check, Seen seen)
{
    *check = (CheckResult){.task = "descent", .is_explained = seen.cause.says != NULL};
    check_fail(check, diagnosis_seen(message_new("found 1"), seen.cause, seen.evidence));
}

// What is offered after a failed check of a task with this answer, or two; `other` or NULL. "" for
// nothing.
static const char *advice_on_two(const char *file, const char *answer, Seen seen, const Seen *other)
{
    static char said[512];
    Manifest manifest = {.lab = "03-kdtree-2d-render",
                         .files = {file},
                         .n_files = 1,
                         .tasks = {{.id = "descent"}},
                         .n_tasks = 1};
    Result result = {.n_checks = other != NULL ? 2 : 1};
    see(&result.checks[0], seen);
    if (other != NULL) {
        see(&result.checks[1], *other);
    }
    char *advice = advice_on_pixels(&manifest, &answer, &result);
    snprintf(said, sizeof said, "%s", advice ? advice : "");
    free(advice);
    result_free(&result);
    return said;
}

static const char asks[] = "color = circles[id].r;";

static const char *advice(const char *file, Seen seen)
{
    return advice_on_two(file, asks, seen, NULL);
}

Test(advice, memcheck_is_offered_where_it_may_help)
{
    cr_expect(strstr(
        advice("a.cl", strange),
        "Some pixels are wrong in no usual way, and descent has an index that may leave "
        "its array, or a variable that is declared without a value: `make memcheck LAB=03`"));
    cr_expect_str_neq(advice_on_two("a.cl", asks, strange, &strange), "");
}

// An answer in which there is nothing for it to find.
Test(advice, memcheck_is_offered_only_for_loose_indices_and_for_what_is_not_set)
{
    static const char *const may[] = {"float minDepth;", "float red, green = 1;",
                                      "for (int i = 0; i <= n; i++) r = circles[i].r;",
                                      "for (int i = 0; i < n; i++) r = circles[i + 1].r;"};
    static const char *const may_not[] = {
        "const int x = get_global_id(0) + width / 2;",
        "for (int i = 0; i < n / 2; i++) if (x < width / 2) r = circles[i].r;",
        "int x = 0, y = 1; if (x >= width) return; // a[i]", "goto end; end: return x;", ""};
    for (size_t i = 0; i < sizeof may / sizeof *may; i++) {
        cr_expect_str_neq(advice_on_two("a.cl", may[i], strange, NULL), "", "%s", may[i]);
    }
    for (size_t i = 0; i < sizeof may_not / sizeof *may_not; i++) {
        cr_expect_str_eq(advice_on_two("a.cl", may_not[i], strange, NULL), "", "%s", may_not[i]);
    }
}

Test(advice, memcheck_is_not_offered_where_the_cause_is_known)
{
    const Seen flipped = {EVIDENCE_PICTURE, {"flipped top to bottom", MISTAKE_FLIPPED_Y}};
    const Seen empty = {.evidence = EVIDENCE_PLAIN_PICTURE};
    const Seen unwritten = {.cause = {.mistake = MISTAKE_UNWRITTEN}};
    const Seen rays = {EVIDENCE_RAYS, {.says = "drawn as if the first sphere were missing"}};
    cr_expect_str_eq(advice("a.cl", flipped), "");
    cr_expect_str_eq(advice("a.cl", empty), "");
    cr_expect_str_eq(advice("a.cl", values), "");
    cr_expect_str_eq(advice_on_two("a.cl", NULL, strange, NULL), "", "an untouched skeleton");
    cr_expect_str_eq(advice_on_two("a.cl", asks, strange, &values), "",
                     "a function check of the same task");
    cr_expect_str_eq(advice_on_two("a.cl", asks, strange, &unwritten), "",
                     "pixels that were not written");
    cr_expect_str_eq(advice_on_two("a.cl", asks, strange, &rays), "", "rays of the same scene");
    cr_expect_str_eq(advice("a.c", strange), "", "a lab without kernels");
}

// A picture whose cause is another task's answer is still strange; what is known of a function says
// nothing about pixels.
Test(advice, memcheck_is_offered_where_only_another_task_is_named)
{
    Seen blamed = strange;
    blamed.cause.says = "alone it passes: search_leaf is wrong, and has a part in this";
    Manifest manifest = {.lab = "03-kdtree-2d-render",
                         .files = {"a.cl"},
                         .n_files = 1,
                         .tasks = {{.id = "descent"}, {.id = "leaf_loop"}},
                         .n_tasks = 2};
    const char *const answers[] = {asks, asks};
    Result result = {.n_checks = 2};
    see(&result.checks[0], blamed);
    result.checks[0].is_explained = 0;  // as blame_others() has it
    see(&result.checks[1], (Seen){.cause = {.says = "the boundary belongs to it"}});
    result.checks[1].task = "leaf_loop";
    char *said = advice_on_pixels(&manifest, answers, &result);
    cr_expect(said != NULL && strstr(said, "Some pixels are wrong in no usual way"), "%s", said);
    free(said);
    result_free(&result);
}

// ---- Shared variables ---------------------------------------------------------------------------

// What is said of a kernel with this text.
static const char *advice_on(const char *source)
{
    static char said[512];
    const Manifest manifest = {.lab = "01-naive-2d", .files = {"host.c", "a.cl"}, .n_files = 2};
    file_write("host.c", "int local;", strlen("int local;"));
    file_write("a.cl", source, strlen(source));
    char *advice = advice_on_local(&manifest, ".");
    snprintf(said, sizeof said, "%s", advice ? advice : "");
    free(advice);
    return said;
}

Test(advice, of_a_local_variable_says_that_a_group_shares_it, .init = folder_enter,
     .fini = folder_leave)
{
    cr_expect_str_eq(advice_on("\n    local float4 color;"),
                     "a.cl:2: all work-items of a group share a `local` variable, also where this "
                     "device let them take turns.");
    cr_expect(strstr(advice_on("__local int n;"), "a.cl:1: all work-items of a group share"));
    cr_expect_str_eq(advice_on("// local\nint x = get_local_id(0);"), "");
}
