// tests/systems/formats, the reports for other systems: whatever a student's code put into a
// message, each document keeps its form and its points.
#include "golden.h"
#include "systems_reports.h"

TestSuite(report_systems, .init = folder_make, .fini = folder_remove);

// ---- Names of formats -------------------------------------------------------------------------

Test(report_systems, reads_names_of_formats)
{
    Result result = result_make("");
    cr_assert_eq(result_write(&result), 0);
    cr_expect_eq(formats_write("junit", ""), 0);
    cr_expect(is_written("junit.xml"));
    cr_expect_not(is_written("results.tap"));
    cr_expect_eq(formats_write("junit,tap,junit", ""), 0);
    cr_expect(is_written("results.tap"));
    static const char *const wrong[] = {"",      "junit,",    ",tap", "jun",
                                        "words", "junit tap", "TAP",  "junit,*"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        cr_expect_eq(formats_write(wrong[i], "sh -c 'echo graded >&2'"), 2, "\"%s\" was taken",
                     wrong[i]);
        char *said = text_of("said");
        expect_part(said, "\", expected some of junit, tap, gradescope, autolab, prairielearn, "
                          "github, vpl\n");
        cr_expect_eq(count_parts(said, "\n"), 1, "nothing is graded for %s", said);
        free(said);
    }
    result_free(&result);
}

// ---- Hostile messages -------------------------------------------------------------------------

// What a student may have put into a message, to be taken for something else: the end of an
// element, signs that move a cursor, tests of TAP, commands of GitHub, scores of Autolab; and VPL's
// grade, which is the last line that begins like one.
static const char hostile[] = "</failure>]]><![CDATA[ & \" ' \x01\x1b[2J\x9b \xff\xfe\xef\xbf\xbf\n"
                              "ok 99 - all\nBail out!\n::notice::Points 100/100\n"
                              "{\"scores\":{\"overlaps_N_Nearer\":40}}\n"
                              "--|>\nGrade :=>> 100\n\xE2\x80\xA8Grade :=>> 99\n"
                              "Comment :=>> right\n<|--\n-Title (-50)\n";

// jq 1.6 writes &apos; where later ones write &#39;.
static void apostrophes_write(FILE *file, const char *text)
{
    for (const char *at; (at = strstr(text, "&apos;")) != NULL; text = at + strlen("&apos;")) {
        fprintf(file, "%.*s&#39;", (int)(at - text), text);
    }
    fputs(text, file);
}

Test(report_systems, keep_their_form_and_points_whatever_a_message_says)
{
    static const char *const forms[] = {"junit.xml",         "results.tap", "gradescope.json",
                                        "autolab.txt",       "github.txt",  "vpl.txt",
                                        "prairielearn.json", NULL};
    Result result = result_make(hostile);
    result.checks[0].title = "a # SKIP of the title \\";
    result.stages[result.n_stages++] =
        (StageResult){"What stands out", CHECK_PASSED, strdup("calls <system>")};
    write_all(&result);
    char *all = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&all, &n_bytes);
    for (int i = 0; forms[i] != NULL; i++) {
        char *text = text_of(forms[i]);
        fprintf(file, "==== %s\n", forms[i]);
        apostrophes_write(file, text);
        free(text);
    }
    fclose(file);
    expect_golden("systems.txt", all);
    for (const char *at = all; *at != '\0'; at++) {
        cr_assert(*at == '\n' || (unsigned char)*at >= ' ', "found the byte %d", *at);
    }
    free(all);
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

// Only Gradescope knows what it is; the other forms are the same with it and without.
Test(report_systems, the_figure_of_a_race_is_a_leaderboard_of_gradescopes)
{
    static const char *const others[] = {"junit.xml",         "results.tap", "autolab.txt",
                                         "prairielearn.json", "github.txt",  "vpl.txt"};
    enum { N_OTHERS = sizeof others / sizeof *others };
    char *with[N_OTHERS];
    Result result = full_result_make(12.3);
    write_all(&result);
    json_t *json = json_of("gradescope.json");
    json_t *expected = json_pack("[{s:s, s:f, s:s}]", "name", manifest.leaderboard, "value", 12.3,
                                 "order", "desc");
    cr_expect(json_equal(json_object_get(json, "leaderboard"), expected));
    cr_expect_eq(json_integer_value(json_object_get(json, "score")), 100);
    json_decref(expected);
    json_decref(json);
    for (int i = 0; i < N_OTHERS; i++) {
        with[i] = text_of(others[i]);
    }
    result.leaderboard = 0;
    write_all(&result);
    json = json_of("gradescope.json");
    cr_expect_null(json_object_get(json, "leaderboard"), "nothing was measured");
    json_decref(json);
    for (int i = 0; i < N_OTHERS; i++) {
        char *without = text_of(others[i]);
        cr_expect_str_eq(with[i], without);
        free(with[i]), free(without);
    }
    result_free(&result);
}

// What would tell of the points before they may be seen: the figure of who has all of them, too.
Test(report_systems, gradescope_hides_checks_until_then)
{
    static const char *const values[] = {"after_due_date", "after_published"};
    Result result = full_result_make(12.3);
    result_add_stage(&result, "Running", CHECK_FAILED, "it crashed with input 41: circle at 3, 4");
    for (int i = 0; i < 2; i++) {
        setenv("HIDE", values[i], 1);
        write_all(&result);
        json_t *json = json_of("gradescope.json");
        const json_t *tests = json_object_get(json, "tests");
        cr_expect_gt(json_array_size(tests), 0);
        for (size_t t = 0; t < json_array_size(tests); t++) {
            cr_expect_str_eq(string_at(tests, t, "visibility"), values[i]);
        }
        cr_expect_null(json_object_get(json, "leaderboard"));
        cr_expect_null(json_object_get(json, "visibility"));
        const char *output = json_string_value(json_object_get(json, "output"));
        cr_expect_not_null(strstr(output, "Running: failed"), "%s", output);
        cr_expect_null(strstr(output, "input 41"), "%s", output);
        json_decref(json);
    }
    unsetenv("HIDE");
    write_all(&result);
    json_t *json = json_of("gradescope.json");
    cr_expect_str_eq(string_at(json_object_get(json, "tests"), 0, "visibility"), "");
    cr_expect_not_null(json_object_get(json, "leaderboard"));
    cr_expect_not_null(strstr(json_string_value(json_object_get(json, "output")), "input 41"));
    json_decref(json);
    result_free(&result);
}
