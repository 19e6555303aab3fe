// tests/systems/formats, the reports for other systems: they stay below the sizes that these take,
// and a fault of the machinery is no zero.
#include "systems_reports.h"

#include <criterion/redirect.h>
#include <math.h>

#define FAULT "The grader could not work. This is no grade; its log says why."

TestSuite(report_systems_limits, .init = folder_make, .fini = folder_remove);

// Does each format say that this is no grade, or nothing?
static void expect_fault(void)
{
    cr_expect_not(is_written("gradescope.json"));
    cr_expect_not(is_written("autolab.txt"));
    cr_expect_not(is_written("github.txt"));
    char *text = text_of("junit.xml");
    expect_part(text, " tests=\"1\" failures=\"0\" errors=\"1\" time=\"0.000\">");
    expect_part(text, "<testcase classname=\"01-naive-2d\" name=\"grader\">");
    expect_part(text, "<error message=\"" FAULT "\">");
    free(text);
    text = text_of("results.tap");
    cr_expect_str_eq(text, "TAP version 13\nBail out! 01-naive-2d: " FAULT "\n");
    free(text);
    text = text_of("prairielearn.json");
    cr_expect_str_eq(text, "{\"gradable\":false,\"format_errors\":[\"" FAULT "\"]}\n");
    free(text);
}

// ---- Figures and sizes ------------------------------------------------------------------------

Test(report_systems_limits, writes_no_figure_that_is_no_number)
{
    Result result = result_make("");
    result.seconds = NAN;
    cr_redirect_stderr();
    cr_expect_eq(result_write(&result), -1);
    cr_expect_eq(formats_write(ALL, ""), 2);
    cr_expect_not(is_written("gradescope.json"));
    expect_fault();
    // Nothing to earn is no division by zero.
    result.seconds = 1;
    result.score = result.max_score = 0;
    write_all(&result);
    json_t *json = json_of("prairielearn.json");
    cr_expect_eq(json_real_value(json_object_get(json, "score")), 0.0);
    json_decref(json);
    result_free(&result);
}

// `n` times `piece`; free() it.
static char *repeated(const char *piece, size_t n)
{
    char *text = calloc(n, strlen(piece) + 1);
    for (size_t i = 0; i < n; i++) {
        memcpy(text + i * strlen(piece), piece, strlen(piece));
    }
    return text;
}

// A picture that no compression makes smaller.
static Image noise_make(unsigned seed)
{
    Image image;
    cr_assert_eq(image_create(256, 256, &image), 0);
    for (int i = 0; i < 256 * 256 * IMAGE_CHANNELS; i++) {
        seed = seed * 1664525u + 1013904223u;
        image.pixels[i] = i % IMAGE_CHANNELS == 3 ? 1 : (float)(seed >> 24) / 255;
    }
    return image;
}

Test(report_systems_limits, stays_below_the_sizes_that_systems_take)
{
    char *message = repeated("\"\\", 8000);
    Result result = result_make("");
    result.n_checks = RESULT_MAX_CHECKS;
    for (int i = 3; i < RESULT_MAX_CHECKS; i++) {
        result.checks[i] = result.checks[1];
        result.checks[i].diagnosis = NOTHING_WRONG;
        result.checks[i].message = strdup(message);
    }
    result.n_stages = RESULT_MAX_STAGES;
    for (int i = 0; i < RESULT_MAX_STAGES; i++) {
        result.stages[i] = (StageResult){"Running", CHECK_FAILED, strdup(message)};
    }
    result.n_pictures = 2;
    for (int i = 0; i < 2; i++) {
        strcpy(result.pictures[i].title, "noise");
        result.pictures[i].own = noise_make(1u + (unsigned)i);
        result.pictures[i].reference = noise_make(7);
    }
    write_all(&result);
    char *text = text_of("prairielearn.json");
    cr_expect_lt(strlen(text), (size_t)1000 * 1000);
    free(text);
    json_t *json = json_of("prairielearn.json");
    // Some fit, and not all six: both sides and the difference of two scenes.
    const size_t n_images = json_array_size(json_object_get(json, "images"));
    cr_expect(n_images > 0 && n_images < 6, "found %zu images", n_images);
    cr_expect_eq(json_array_size(json_object_get(json, "tests")), RESULT_MAX_CHECKS);
    text = text_of("gradescope.json");
    cr_expect_lt(strlen(text), (size_t)1000 * 1000);
    free(text);
    json_decref(json);
    json = json_of("gradescope.json");
    size_t n_bytes = 0;
    const json_t *tests = json_object_get(json, "tests");
    for (size_t i = RESULT_MAX_CHECKS; i < json_array_size(tests); i++) {
        n_bytes += strlen(string_at(tests, i, "output"));
    }
    cr_expect(n_bytes > 100 * 1000 && n_bytes <= 400 * 1000, "found %zu bytes of pictures",
              n_bytes);
    json_decref(json);
    free(message);
    result_free(&result);
}

Test(report_systems_limits, shows_wrong_pictures_and_no_right_ones)
{
    Result result = result_make("");
    result.n_pictures = 2;
    strcpy(result.pictures[0].title, "right <b>");
    strcpy(result.pictures[1].title, "wrong <b>");
    for (int i = 0; i < 2; i++) {
        cr_assert_eq(image_create(4, 3, &result.pictures[i].own), 0);
        cr_assert_eq(image_create(4, 3, &result.pictures[i].reference), 0);
    }
    result.pictures[1].own.pixels[5] = 1;
    write_all(&result);
    json_t *json = json_of("prairielearn.json");
    const json_t *images = json_object_get(json, "images");
    cr_expect_eq(json_array_size(images), 3);
    cr_expect_str_eq(string_at(images, 0, "label"), "wrong <b> (yours)");
    cr_expect_str_eq(string_at(images, 1, "label"), "wrong <b> (as it should be)");
    cr_expect_str_eq(
        string_at(images, 2, "label"),
        "wrong <b> (the difference: black where equal, pale yellow from 0.5 on, cyan where NaN)");
    expect_part(string_at(images, 0, "url"), "data:image/png;base64,iVBOR");
    json_decref(json);
    json = json_of("gradescope.json");
    const json_t *tests = json_object_get(json, "tests");
    cr_expect_eq(json_array_size(tests), 6);
    cr_expect_str_eq(string_at(tests, 3, "output_format"), "html");
    expect_part(string_at(tests, 3, "output"), "<img alt=\"wrong &lt;b&gt; (yours)\" src=\"data:");
    json_decref(json);
    // Of the next result nothing is wrong: older pictures are gone.
    result.pictures[1].own.pixels[5] = 0;
    write_all(&result);
    cr_expect_not(is_written("pictures.json"));
    json = json_of("prairielearn.json");
    cr_expect_eq(json_array_size(json_object_get(json, "images")), 0);
    json_decref(json);
    result_free(&result);
}

// ---- What was not judged ----------------------------------------------------------------------

// Is the result gradable for PrairieLearn when this stage failed and no check, or one, was judged?
static int gradable_after(const char *stage, CheckStatus one_check)
{
    Result result = result_make("");
    result.stages[0] = (StageResult){stage, CHECK_FAILED, strdup("a.cl: not there")};
    for (int i = 0; i < result.n_checks; i++) {
        result.checks[i].status = CHECK_NOT_RUN;
        result.checks[i].points = 0;
    }
    result.checks[2].status = one_check;
    result.score = 0;
    write_all(&result);
    json_t *json = json_of("prairielearn.json");
    const int gradable = json_is_true(json_object_get(json, "gradable"));
    cr_expect_eq(gradable, json_object_get(json, "score") != NULL);
    if (!gradable) {
        const json_t *errors = json_object_get(json, "format_errors");
        cr_expect_str_eq(json_string_value(json_array_get(errors, 0)), "a.cl: not there");
    }
    json_decref(json);
    result_free(&result);
    return gradable;
}

Test(report_systems_limits, prairielearn_grades_what_could_be_judged)
{
    cr_expect_eq(gradable_after("Staging", CHECK_NOT_RUN), 0);
    cr_expect_eq(gradable_after("Compiling", CHECK_NOT_RUN), 0);
    // One answer was tried alone, and was wrong: that is an attempt.
    cr_expect_eq(gradable_after("Compiling", CHECK_FAILED), 1);
    cr_expect_eq(gradable_after("Running", CHECK_NOT_RUN), 1);
}

Test(report_systems_limits, a_fault_is_no_zero)
{
    // Where nothing lies, and where no result was written.
    cr_expect_eq(formats_write(ALL, "sh -c 'exit 2'"), 2);
    expect_fault();
    cr_expect_eq(formats_write(ALL, ""), 2);
    expect_fault();
    char *said = text_of("said");
    expect_part(said, "/results.json: there is no result\n");
    free(said);
    // Where an older result lies, by whatever the grader ended.
    Result result = result_make("");
    static const char *const ends[] = {"sh -c 'exit 2'", "sh -c 'kill -9 $$'", "/no/such/program"};
    static const int statuses[] = {2, 137, 127};
    for (int i = 0; i < 3; i++) {
        write_all(&result);
        cr_expect_eq(formats_write(ALL, ends[i]), statuses[i]);
        expect_fault();
    }
    // Status 1 is a verdict.
    cr_expect_eq(formats_write(ALL, "sh -c 'exit 1'"), 1);
    cr_expect(is_written("gradescope.json"));
    result_free(&result);
}

Test(report_systems_limits, a_result_that_is_none_leaves_no_file)
{
    Result result = result_make("");
    static const char *const broken[] = {"{", "{}", "[]", " "};
    for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
        write_all(&result);
        char line[128];
        snprintf(line, sizeof line, "sh -c 'echo \"%s\" >%s/results.json'", broken[i], folder);
        cr_expect_eq(formats_write(ALL, line), 2, "%s was taken", broken[i]);
        cr_expect_not(is_written("gradescope.json"));
        cr_expect_not(is_written("prairielearn.json"));
        cr_expect_not(is_written("autolab.txt"));
    }
    result_free(&result);
}
