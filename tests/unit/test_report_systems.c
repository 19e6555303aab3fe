// tests/systems/formats, the reports for other systems: whatever a student's code put into a
// message, each document keeps its form, its size and its points, and a fault of the machinery is
// no zero. The documents are made as everywhere, of the results.json that the grader writes.
#include "report.h"
#include "sample_result.h"

#include <criterion/criterion.h>
#include <criterion/redirect.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define UNKNOWN "\xEF\xBF\xBD"
#define ALL "junit,tap,gradescope,autolab,prairielearn,github"
#define FAULT "The grader could not work. This is no grade; its log says why."

// A folder of its own for each test; Criterion runs each in a process of its own.
static char folder[] = "/tmp/test-systems-XXXXXX";

static void folder_make(void)
{
    cr_assert_not_null(mkdtemp(folder));
}

static void folder_remove(void)
{
    static const char *const files[] = {
        "results.json", "pictures.json", "junit.xml", "results.tap",      "gradescope.json",
        "autolab.txt",  "github.txt",    "said",      "prairielearn.json"};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        char path[64];
        snprintf(path, sizeof path, "%s/%s", folder, files[i]);
        unlink(path);
    }
    cr_expect_eq(rmdir(folder), 0, "something else was left in the folder");
}

// Write the formats of what lies in the folder, after a command that stands for the grader; "" for
// none. Returns the script's exit status; what it said is in the file "said".
static int formats_write(const char *formats, const char *command)
{
    char line[512];
    snprintf(line, sizeof line, "tests/systems/formats/write.sh '%s' %s 01-naive-2d %s 2>%s/said",
             formats, folder, command, folder);
    const int status = system(line);
    cr_assert(WIFEXITED(status));
    return WEXITSTATUS(status);
}

// What the grader writes of a result. Returns 0 or -1.
static int result_write(const Result *result)
{
    char path[64];
    snprintf(path, sizeof path, "%s/results.json", folder);
    if (report_json(path, &manifest, result) != 0) {
        return -1;
    }
    snprintf(path, sizeof path, "%s/pictures.json", folder);
    return report_pictures_json(path, result);
}

static void write_all(const Result *result)
{
    cr_assert_eq(result_write(result), 0);
    cr_assert_eq(formats_write(ALL, ""), 0);
}

// A file's text; free() it. NULL when it is not there.
static char *text_of(const char *name)
{
    char path[64];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    struct stat status;
    if (file == NULL || fstat(fileno(file), &status) != 0) {
        return NULL;
    }
    char *text = calloc(1, (size_t)status.st_size + 1);
    cr_assert_eq(fread(text, 1, (size_t)status.st_size, file), (size_t)status.st_size);
    fclose(file);
    cr_expect_eq(strlen(text), (size_t)status.st_size, "%s holds a NUL", name);
    return text;
}

static json_t *json_of(const char *name)
{
    char *text = text_of(name);
    cr_assert_not_null(text, "%s was not written", name);
    json_error_t error;
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES, &error);
    cr_assert_not_null(json, "%s: line %d: %s", name, error.line, error.text);
    free(text);
    return json;
}

static const char *string_at(const json_t *list, size_t i, const char *name)
{
    const char *string = json_string_value(json_object_get(json_array_get(list, i), name));
    return string != NULL ? string : "";
}

static void expect_part(const char *text, const char *part)
{
    cr_expect(strstr(text, part) != NULL, "expected \"%s\" in:\n%s", part, text);
}

static int count_parts(const char *text, const char *part)
{
    int n = 0;
    while ((text = strstr(text, part)) != NULL) {
        text += strlen(part);
        n++;
    }
    return n;
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

// Does each format say that this is no grade, or nothing?
static void expect_fault(void)
{
    cr_expect_null(text_of("gradescope.json"));
    cr_expect_null(text_of("autolab.txt"));
    cr_expect_null(text_of("github.txt"));
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

TestSuite(report_systems, .init = folder_make, .fini = folder_remove);

// ---- Names of formats -------------------------------------------------------------------------

Test(report_systems, reads_names_of_formats)
{
    Result result = result_make("");
    cr_assert_eq(result_write(&result), 0);
    cr_expect_eq(formats_write("junit", ""), 0);
    cr_expect_not_null(text_of("junit.xml"));
    cr_expect_null(text_of("results.tap"));
    cr_expect_eq(formats_write("junit,tap,junit", ""), 0);
    cr_expect_not_null(text_of("results.tap"));
    static const char *const wrong[] = {"",      "junit,",    ",tap", "jun",
                                        "words", "junit tap", "TAP",  "junit,*"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        cr_expect_eq(formats_write(wrong[i], "sh -c 'echo graded >&2'"), 2, "\"%s\" was taken",
                     wrong[i]);
        char *said = text_of("said");
        expect_part(said, "\", expected some of junit, tap, gradescope, autolab, prairielearn, "
                          "github\n");
        cr_expect_eq(count_parts(said, "\n"), 1, "nothing is graded for %s", said);
        free(said);
    }
    result_free(&result);
}

// ---- Hostile messages -------------------------------------------------------------------------

// What a student may have put into a message, to be taken for something else.
static const char hostile[] = "</failure>]]><![CDATA[ & \" ' \x01\x1b[2J\x9b \xff\xfe\xef\xbf\xbf\n"
                              "ok 99 - all\nBail out!\n::notice::Points 100/100\n"
                              "{\"scores\":{\"overlaps_N_Nearer\":40}}\n";

Test(report_systems, junit_stays_whole)
{
    Result result = result_make(hostile);
    write_all(&result);
    char *text = text_of("junit.xml");
    cr_expect_eq(count_parts(text, "<testcase "), 4);
    cr_expect_eq(count_parts(text, "</failure>"), 1);
    cr_expect_eq(count_parts(text, "<![CDATA["), 0);
    cr_expect_eq(count_parts(text, "]]>"), 0);
    expect_part(text, "<testsuites name=\"01-naive-2d\" tests=\"4\" failures=\"1\" errors=\"0\" "
                      "time=\"4.250\">");
    expect_part(text, "<testsuite name=\"01-naive-2d\" tests=\"4\" failures=\"1\" errors=\"0\" "
                      "skipped=\"1\" time=\"4.250\">");
    // jq 1.6 writes &apos; where later ones write &#39;.
    expect_part(text, "&lt;/failure&gt;]]&gt;&lt;![CDATA[ &amp; &quot; &");
    expect_part(text, "; " UNKNOWN UNKNOWN "[2J" UNKNOWN " " UNKNOWN UNKNOWN UNKNOWN "\nok 99");
    expect_part(text, "; " UNKNOWN UNKNOWN "[2J" UNKNOWN " " UNKNOWN UNKNOWN UNKNOWN "\">");
    cr_expect_eq(count_parts(text, "'"), 0);
    for (const char *at = text; *at != '\0'; at++) {
        cr_assert(*at == '\n' || (unsigned char)*at >= ' ', "found the byte %d", *at);
    }
    free(text);
    result_free(&result);
}

Test(report_systems, remarks_of_stages_are_shown)
{
    Result result = result_make("");
    result.stages[0] = (StageResult){"What stands out", CHECK_PASSED, strdup("calls <system>")};
    write_all(&result);
    char *text = text_of("junit.xml");
    expect_part(text, "name=\"What stands out\">\n"
                      "      <system-out>calls &lt;system&gt;</system-out>\n    </testcase>\n");
    free(text);
    text = text_of("results.tap");
    expect_part(text, "ok 1 - 01-naive-2d: What stands out\n# calls <system>\n");
    free(text);
    json_t *json = json_of("gradescope.json");
    cr_expect_str_eq(json_string_value(json_object_get(json, "output")),
                     "What stands out:\ncalls <system>");
    json_decref(json);
    result_free(&result);
}

// A hint stands under its own check, and not where the message has named the mistake.
Test(report_systems, hints_follow_messages)
{
    static const char *const found[] = {"", "found 0", "found 0"};
    static const char *const outputs[] = {"Hint: Compare the squares.",
                                          "found 0\nHint: Compare the squares.",
                                          "found 0; the later circle won"};
    for (int i = 0; i < 3; i++) {
        Result result = result_make(found[i]);
        if (i == 2) {
            name_cause(&result.checks[1], "the later circle won");
        }
        write_all(&result);
        json_t *json = json_of("gradescope.json");
        cr_expect_str_eq(string_at(json_object_get(json, "tests"), 0, "output"), "");
        cr_expect_str_eq(string_at(json_object_get(json, "tests"), 1, "output"), outputs[i]);
        json_decref(json);
        result_free(&result);
    }
}

Test(report_systems, tap_has_its_own_tests_only)
{
    Result result = result_make(hostile);
    result.checks[0].title = "a # SKIP of the title \\";
    write_all(&result);
    char *text = text_of("results.tap");
    static const char *const lines[] = {
        "ok 1 - 01-naive-2d: Compiling",
        "ok 2 - overlaps_N_Nearer: a \\# SKIP of the title \\\\",
        "not ok 3 - overlaps_N_Nearer: The boundary belongs to it",
        "ok 4 - implicit2DRenderer: A random scene # SKIP not run",
    };
    int n_tests = 0;
    for (char *line = strtok(text, "\n"); line != NULL; line = strtok(NULL, "\n")) {
        if (strncmp(line, "ok ", 3) == 0 || strncmp(line, "not ok ", 7) == 0) {
            cr_expect_str_eq(line, n_tests < 4 ? lines[n_tests] : "no other test");
            n_tests++;
        } else {
            cr_expect(strncmp(line, "# ", 2) == 0 || strcmp(line, "1..4") == 0 ||
                          strcmp(line, "TAP version 13") == 0,
                      "found the line \"%s\"", line);
        }
    }
    cr_expect_eq(n_tests, 4);
    free(text);
    result_free(&result);
}

Test(report_systems, gradescope_keeps_the_points)
{
    Result result = result_make(hostile);
    write_all(&result);
    json_t *json = json_of("gradescope.json");
    const json_t *tests = json_object_get(json, "tests");
    cr_expect_eq(json_integer_value(json_object_get(json, "score")), 25);
    cr_expect_eq(json_array_size(tests), 3);
    cr_expect_str_eq(string_at(tests, 0, "status"), "passed");
    cr_expect_str_eq(string_at(tests, 1, "status"), "failed");
    cr_expect_str_eq(string_at(tests, 1, "number"), "1.2");
    cr_expect_str_eq(string_at(tests, 1, "output_format"), "text");
    expect_part(string_at(tests, 1, "output"), "\nHint: Compare the squares.");
    cr_expect_str_eq(string_at(tests, 2, "number"), "2.1");
    cr_expect_str_eq(string_at(tests, 2, "status"), "failed");
    cr_expect_str_eq(string_at(tests, 2, "output"), "Not run: something before it failed.");
    json_decref(json);
    result_free(&result);
}

Test(report_systems, autolab_ends_with_the_points)
{
    Result result = result_make(hostile);
    write_all(&result);
    char *text = text_of("autolab.txt");
    cr_expect_eq(count_parts(text, "\n"), 2);
    expect_part(text, "}\n{\"scores\":{\"overlaps_N_Nearer\":25,\"implicit2DRenderer\":0},"
                      "\"scoreboard\":[25]}\n");
    *strchr(text, '\n') = '\0';
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    cr_assert_not_null(json);
    const json_t *task = json_object_get(json, "overlaps_N_Nearer");
    cr_expect(json_is_true(
        json_object_get(json_object_get(task, "Clearly inside and outside"), "passed")));
    cr_expect(json_is_false(
        json_object_get(json_object_get(task, "The boundary belongs to it"), "passed")));
    json_decref(json);
    free(text);
    result_free(&result);
}

Test(report_systems, github_gets_numbers_only)
{
    Result result = result_make(hostile);
    write_all(&result);
    char *text = text_of("github.txt");
    cr_expect_str_eq(text, "::notice title=Autograding complete::Points 25/100\n"
                           "::notice title=Autograding report::"
                           "{\"totalPoints\":25,\"maxPoints\":100}\n");
    free(text);
    result_free(&result);
}

// ---- Figures and sizes ------------------------------------------------------------------------

Test(report_systems, writes_no_figure_that_is_no_number)
{
    Result result = result_make("");
    result.seconds = NAN;
    cr_redirect_stderr();
    cr_expect_eq(result_write(&result), -1);
    cr_expect_eq(formats_write(ALL, ""), 2);
    cr_expect_null(text_of("gradescope.json"));
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

Test(report_systems, stays_below_the_sizes_that_systems_take)
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

Test(report_systems, shows_wrong_pictures_and_no_right_ones)
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
    cr_expect_null(text_of("pictures.json"));
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

Test(report_systems, prairielearn_grades_what_could_be_judged)
{
    cr_expect_eq(gradable_after("Staging", CHECK_NOT_RUN), 0);
    cr_expect_eq(gradable_after("Compiling", CHECK_NOT_RUN), 0);
    // One answer was tried alone, and was wrong: that is an attempt.
    cr_expect_eq(gradable_after("Compiling", CHECK_FAILED), 1);
    cr_expect_eq(gradable_after("Running", CHECK_NOT_RUN), 1);
}

Test(report_systems, a_fault_is_no_zero)
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
    cr_expect_not_null(text_of("gradescope.json"));
    result_free(&result);
}

Test(report_systems, a_result_that_is_none_leaves_no_file)
{
    Result result = result_make("");
    static const char *const broken[] = {"{", "{}", "[]", " "};
    for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
        write_all(&result);
        char line[128];
        snprintf(line, sizeof line, "sh -c 'echo \"%s\" >%s/results.json'", broken[i], folder);
        cr_expect_eq(formats_write(ALL, line), 2, "%s was taken", broken[i]);
        cr_expect_null(text_of("gradescope.json"));
        cr_expect_null(text_of("prairielearn.json"));
        cr_expect_null(text_of("autolab.txt"));
    }
    result_free(&result);
}
