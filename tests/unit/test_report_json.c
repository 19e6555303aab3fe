// results.json: every field is written, and what was written is read back for the gradebook.
#include "graded.h"
#include "report_texts.h"

#include <criterion/redirect.h>
#include <jansson.h>

// ---- results.json -------------------------------------------------------------------------------

Test(report_json, reads_back_with_every_field)
{
    Result result = result_make("\"quoted\" \\ \x01 \xFF end");
    char *text = file_report(report_json, &result);
    json_t *found = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    json_t *expected = json_pack(
        "{s:s, s:s, s:i, s:i, s:s, s:s, s:s, s:s, s:f, s:[{s:s, s:s, s:s}],"
        " s:[{s:s, s:s, s:s, s:i, s:i, s:s}, {s:s, s:s, s:s, s:i, s:i, s:s}],"
        " s:[{s:s, s:s, s:s, s:i, s:i, s:s, s:s, s:s},"
        " {s:s, s:s, s:s, s:i, s:i, s:s, s:s, s:s},"
        " {s:s, s:s, s:s, s:i, s:i, s:s, s:s, s:s}]}",
        "lab", "01-naive-2d", "title", "Naive 2D rendering", "score", 25, "max_score", 100, "seed",
        "18446744073709551615", "device", "cpu-x", "sandbox", "bubblewrap", "submission",
        "labs/01-naive-2d", "seconds", 4.25,
        // stages
        "stages", "title", "Compiling", "status", "passed", "message", "",
        // tasks
        "tasks", "id", "overlaps_N_Nearer", "title", "Does a circle cover the pixel?", "file",
        "overlaps_N_Nearer.cl", "points", 25, "max_points", 40, "hint", "Compare the squares.",
        "id", "implicit2DRenderer", "title", "The nearest of all", "file", "implicit2DRenderer.cl",
        "points", 0, "max_points", 60, "hint", "",
        // checks
        "checks", "id", "overlaps-inside", "title", "Clearly inside and outside", "task",
        "overlaps_N_Nearer", "points", 25, "max_points", 25, "status", "passed", "message", "",
        "hint", "", "id", "overlaps-boundary", "title", "The boundary belongs to it", "task",
        "overlaps_N_Nearer", "points", 0, "max_points", 15, "status", "failed", "message",
        "\"quoted\" \\ \\x01 \\xFF end", "hint", "Compare the squares.", "id", "picture", "title",
        "A random scene", "task", "implicit2DRenderer", "points", 0, "max_points", 60, "status",
        "not-run", "message", "", "hint", "");
    cr_assert_not_null(expected);
    cr_expect(json_equal(found, expected), "found %s", text);
    json_decref(expected);
    json_decref(found);
    free(text);
    result_free(&result);
}

Test(report_json, is_not_written_with_a_figure_that_is_no_number, .init = cr_redirect_stderr)
{
    Result result = result_make("");
    result.seconds = 0.0 / 0.0;
    cr_expect_eq(report_json("/tmp/test-report-never-written.json", &manifest, &result), -1);
    result.seconds = 1;
    result.leaderboard = 0.0 / 0.0;
    cr_expect_eq(report_json("/tmp/test-report-never-written.json", &manifest, &result), -1);
    cr_expect_eq(access("/tmp/test-report-never-written.json", F_OK), -1);
    result_free(&result);
}

// What is not measured is not there, and never a zero.
Test(report_json, has_a_leaderboard_only_where_there_is_a_figure)
{
    static const double figures[] = {0, 12.3, 0.1, 1000};
    static const char *const texts[] = {NULL, "\"value\": 12.3\n", "\"value\": 0.1\n",
                                        "\"value\": 1000.0\n"};
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++) {
        Result result = full_result_make(figures[i]);
        char *text = file_report(report_json, &result);
        if (texts[i] == NULL) {
            expect_no_part(text, "leaderboard");
        } else {
            expect_part(text, "  \"leaderboard\": {\n"
                              "    \"title\": \"times as fast as lab 00's <kernel>\",\n    ");
            expect_part(text, texts[i]);
        }
        free(text);
        result_free(&result);
    }
}

// ---- Reading results.json back ------------------------------------------------------------------

static int graded_load_text(const char *text, Graded *graded)
{
    char path[] = "/tmp/test-graded-XXXXXX";
    FILE *file = fdopen(mkstemp(path), "w");
    fputs(text, file);
    fclose(file);
    int loaded = graded_load(path, graded);
    unlink(path);
    return loaded;
}

// The sentence of a known mistake is a field of its own, so that others need not look for it in
// the message.
Test(graded, reads_the_known_mistake_apart)
{
    Result result = result_make("");
    Graded graded;
    check_fail(&result.checks[1],
               diagnosis_of(strdup("found 1; expected 0"), (Cause){.says = "it is strict"}));
    char *text = file_report(report_json, &result);
    cr_assert_eq(graded_load_text(text, &graded), 0);
    cr_expect_str_eq(graded.checks[1].message, "found 1; expected 0; it is strict");
    cr_expect_str_eq(graded.checks[1].cause, "it is strict");
    cr_expect_str_eq(graded.checks[1].task, "overlaps_N_Nearer");
    cr_expect_null(graded.checks[0].cause);
    graded_free(&graded);
    free(text);
    result_free(&result);
}

// Why a check says nothing of the answer, and where it was seen, likewise.
Test(graded, reads_apart_why_nothing_is_said)
{
    static const char *const words[N_SILENCES] = {NULL, "unanswered", "untried", "ended"};
    for (Silence silence = SILENCE_NONE; silence < N_SILENCES; silence++) {
        Result result = result_make("");
        Graded graded;
        check_fail(&result.checks[1], diagnosis_silent(silence, "some words"));
        result.checks[1].diagnosis.evidence =
            silence == SILENCE_NONE ? EVIDENCE_PICTURE : EVIDENCE_VALUES;
        char *text = file_report(report_json, &result);
        cr_assert_eq(graded_load_text(text, &graded), 0);
        const char *read = graded.checks[1].silent;
        cr_expect(read == words[silence] || (read != NULL && strcmp(read, words[silence]) == 0));
        cr_expect_eq(strstr(text, "\"in_picture\": true") != NULL, silence == SILENCE_NONE);
        graded_free(&graded);
        free(text);
        result_free(&result);
    }
}

Test(graded, reads_what_the_grader_wrote)
{
    Result result = result_make("wrong");
    char *text = file_report(report_json, &result);
    Graded graded;
    cr_assert_eq(graded_load_text(text, &graded), 0);
    cr_expect_str_eq(graded.lab, "01-naive-2d");
    cr_expect_eq(graded.score, 25);
    cr_assert_eq(graded.n_tasks, 2);
    cr_expect_eq(graded.tasks[0].points, 25);
    cr_assert_eq(graded.n_checks, 3);
    cr_expect_eq(graded.checks[1].status, CHECK_FAILED);
    cr_expect_str_eq(graded.checks[1].message, "wrong");
    cr_expect_null(graded.failed_stage);
    graded_free(&graded);
    free(text);
    result_free(&result);
}

Test(graded, reads_the_figure_of_a_race)
{
    static const double figures[] = {0, 12.3};
    for (size_t i = 0; i < 2; i++) {
        Result result = full_result_make(figures[i]);
        char *text = file_report(report_json, &result);
        Graded graded;
        cr_assert_eq(graded_load_text(text, &graded), 0);
        cr_expect_eq(graded.leaderboard, figures[i]);
        cr_expect_str_eq(graded.leaderboard_title ? graded.leaderboard_title : "none",
                         i ? manifest.leaderboard : "none");
        graded_free(&graded);
        free(text);
        result_free(&result);
    }
}

// The text with one part replaced. The result is static.
static const char *edited(const char *text, const char *part, const char *replacement)
{
    static char edited_text[8192];
    const char *at = strstr(text, part);
    cr_assert_not_null(at, "no \"%s\" in %s", part, text);
    snprintf(edited_text, sizeof edited_text, "%.*s%s%s", (int)(at - text), text, replacement,
             at + strlen(part));
    return edited_text;
}

Test(graded, refuses_a_figure_that_is_none, .init = cr_redirect_stderr)
{
    static const char *const values[] = {
        "0",    "0.0",      "-1.5",   "1e300", "1e999", "NaN",  "1000.1",
        "null", "\"12.3\"", "[12.3]", "0.09",  "true",  "\"\"", "12.3, \"more\": 1"};
    Result result = full_result_make(12.3);
    char *text = file_report(report_json, &result);
    Graded graded;
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        cr_expect_eq(graded_load_text(edited(text, "12.3", values[i]), &graded), -1, "%s was taken",
                     values[i]);
        cr_expect_null(graded.json);
    }
    free(text);
    // Who has not every point has none.
    result.checks[0].points = 24;
    result.score = 99;
    text = file_report(report_json, &result);
    cr_expect_eq(graded_load_text(text, &graded), -1);
    free(text);
    result_free(&result);
}

Test(graded, refuses_what_the_grader_never_writes, .init = cr_redirect_stderr)
{
    // What is replaced, and by what; the result then no longer holds together.
    static const char *const edits[][2] = {
        {"\"score\": 25", "\"score\": 100"},
        {"\"score\": 25", "\"score\": 25.0"},
        {"\"score\": 25", "\"score\": \"25\""},
        {"\"score\": 25,", "\"score\": 25, \"bonus\": 75,"},
        {"\"max_score\": 100", "\"max_score\": 25"},
        {"\"lab\": \"01-naive-2d\"", "\"lab\": null"},
        {"\"lab\"", "\"lab\": \"x\", \"lab\""},
        {"\"stages\": [", "\"stages\": [5, "},
        {"\"status\": \"failed\"", "\"status\": \"excused\""},
        {"\"task\": \"implicit2DRenderer\"", "\"task\": \"other\""},
        {"\"points\": 25,\n      \"max_points\": 40", "\"points\": 40,\n      \"max_points\": 40"},
        {"{", "["},
    };
    Result result = result_make("wrong");
    char *text = file_report(report_json, &result);
    for (size_t i = 0; i < sizeof edits / sizeof edits[0]; i++) {
        Graded graded;
        cr_expect_eq(graded_load_text(edited(text, edits[i][0], edits[i][1]), &graded), -1,
                     "edit %zu was taken", i);
        cr_expect_null(graded.json);
    }
    Graded graded;
    cr_expect_eq(graded_load("/dev/zero", &graded), -1);
    cr_expect_eq(graded_load("/nowhere/results.json", &graded), -1);
    free(text);
    result_free(&result);
}
