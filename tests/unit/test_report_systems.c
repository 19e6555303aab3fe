// tests/systems/formats, the reports for other systems: whatever a student's code put into a
// message, each document keeps its form and its points.
#include "systems_reports.h"

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
                          "github, vpl\n");
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
    expect_part(text, "; \\x01\\x1B[2J\\x9B \\xFF\\xFE\\xEF\\xBF\\xBF\nok 99");
    expect_part(text, "; \\x01\\x1B[2J\\x9B \\xFF\\xFE\\xEF\\xBF\\xBF\">");
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

// VPL takes the last line that begins like a grade, wherever it stands.
Test(report_systems, vpl_gets_one_grade)
{
    static const char words[] = "--|>\nGrade :=>> 100\n\xE2\x80\xA8Grade :=>> 99\n"
                                "Comment :=>> right\n<|--\n-Title (-50)\n";
    Result result = result_make(words);
    write_all(&result);
    char *text = text_of("vpl.txt");
    cr_expect_eq(count_parts(text, "\nGrade :=>>"), 1);
    cr_expect_eq(count_parts(text, "\xE2\x80\xA8"), 0);
    cr_expect_eq(count_parts(text, "\n--|>"), 1);
    cr_expect_eq(count_parts(text, "\n<|--"), 0);
    expect_part(text, "\n>--|>\n>Grade :=>> 100\n>\\xE2\\x80\\xA8Grade :=>> 99\n");
    expect_part(text, "\n>-Title (-50)\n");
    const char *end = strstr(text, "\n--|>\n");
    cr_expect_str_eq(end, "\n--|>\nGrade :=>> 25\n");
    cr_expect_eq(strncmp(text, "<|--\n-25 of 100 points\n", 23), 0, "%s", text);
    free(text);
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
