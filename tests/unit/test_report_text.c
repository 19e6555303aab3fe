// The text report, and what all reports say together: a message, and the hint that belongs to it.
#include "hints.h"
#include "report_texts.h"

// ---- The text report ----------------------------------------------------------------------------

Test(report_text, is_laid_out_by_task)
{
    Result result =
        result_make("pixel (3, 4), circle (0, 0) radius 5: found 0, expected 1, it looks "
                    "strict where the boundary belongs to the circle");
    result.seed = 42;
    char *text = text_report(&result, 0);
    cr_expect_str_eq(
        text,
        "01-naive-2d  Naive 2D rendering\n"
        " seed 42, device cpu-x, sandbox bubblewrap\n"
        " submission labs/01-naive-2d\n"
        "\n"
        " Task overlaps_N_Nearer in overlaps_N_Nearer.cl: Does a circle cover the pixel?           "
        " 25/40\n"
        "   ok    overlaps-inside      25/25  Clearly inside and outside\n"
        "   FAIL  overlaps-boundary     0/15  The boundary belongs to it\n"
        "         pixel (3, 4), circle (0, 0) radius 5: found 0, expected 1, it looks strict where "
        "the\n"
        "         boundary belongs to the circle\n"
        "         Hint: Compare the squares.\n"
        "\n"
        " Task implicit2DRenderer in implicit2DRenderer.cl: The nearest of all                     "
        "  0/60\n"
        "   --    picture               0/60  A random scene\n"
        "\n"
        " Score 25/100\nReport: 03/report.html\n",
        "found:\n%s", text);
    free(text);
    result_free(&result);
}

static char *told_report(const Result *result, const char *task)
{
    FILE *file = tmpfile();
    report_text(file, &manifest, result, (ReportTold){.task = task}, 0);
    return stream_text(file);
}

// The first that failed, or the one that is asked for; of the others a line each.
Test(report_text, tells_one_task_at_a_time)
{
    Result result = result_make("found 0, expected 1");
    check_fail(&result.checks[2], diagnosis_new("found black, expected red"));
    char *text = told_report(&result, NULL);
    expect_part(text, "   FAIL  overlaps_N_Nearer     25/40  Does a circle cover the pixel?\n"
                      "   FAIL  implicit2DRenderer     0/60  The nearest of all\n"
                      "\n"
                      " Task overlaps_N_Nearer in ");
    expect_part(text, "found 0, expected 1");
    expect_no_part(text, "found black");
    expect_part(text, "\n 1 more task fails; TASK=implicit2DRenderer shows it, ALL=1 everything\n"
                      "\n Next: overlaps_N_Nearer in overlaps_N_Nearer.cl\n"
                      "\n Score 25/100\n");
    free(text);
    text = told_report(&result, "implicit2DRenderer");
    expect_part(text, "found black, expected red");
    expect_no_part(text, "found 0");
    expect_part(text, "\n Next: implicit2DRenderer in implicit2DRenderer.cl\n");
    expect_part(text, " 1 more task fails; TASK=overlaps_N_Nearer shows it");
    free(text);
    result_free(&result);
}

// Whatever came out, there is one thing to do next.
Test(report_text, names_the_next_step)
{
    Result result = result_make("found 0, expected 1");
    result.stages[0] = (StageResult){"Compiling", CHECK_FAILED, NULL};
    char *text = told_report(&result, NULL);
    expect_part(text, "\n Next: correct what \"Compiling\" says above, then grade again\n\n Score");
    free(text);
    result.stages[0] = (StageResult){"Running", CHECK_FAILED, NULL};
    text = told_report(&result, NULL);
    expect_part(text, "\n Next: overlaps_N_Nearer in overlaps_N_Nearer.cl\n");
    free(text);
    check_pass(&result.checks[1]);
    text = told_report(&result, NULL);
    expect_part(text, "\n Next: implicit2DRenderer in implicit2DRenderer.cl\n");
    free(text);
    check_pass(&result.checks[2]);
    text = told_report(&result, NULL);
    expect_part(text, "\n Next: correct what \"Running\" says above, then grade again\n");
    free(text);
    result.stages[0] = (StageResult){"Running", CHECK_PASSED, NULL};
    text = told_report(&result, NULL);
    expect_part(text, "\n Next: nothing is missing; hand in overlaps_N_Nearer.cl and "
                      "implicit2DRenderer.cl\n");
    free(text);
    result_free(&result);
}

Test(report_text, ends_with_the_figure_of_a_race_where_there_is_one)
{
    Result result = full_result_make(12.34);
    char *text = text_report(&result, 0);
    expect_part(text, "\n Score 100/100\n"
                      " 12.3 times as fast as lab 00's <kernel> on this device, in this run; "
                      "gives and costs no points\n"
                      "Report: 03/report.html\n");
    free(text);
    result.leaderboard = 0;
    text = text_report(&result, 0);
    expect_part(text, "\n Score 100/100\n");
    expect_no_part(text, "fast");
    free(text);
    result_free(&result);
}

// To systems the checks of a task that nobody has answered have failed; to people it is no fault.
Test(report_text, shows_what_is_not_answered_as_not_tried)
{
    Result result = result_make("not answered yet");
    result.checks[1].diagnosis.silence = SILENCE_UNANSWERED;
    char *texts[] = {text_report(&result, 0), file_report(report_html, &result),
                     file_report(report_json, &result)};
    expect_part(texts[0], "   --    overlaps-boundary ");
    expect_no_part(texts[0], "FAIL");
    expect_part(texts[1], "<div class=\"check not-run\" id=\"overlaps-boundary\">");
    expect_part(texts[2], "\"status\": \"failed\"");
    for (int i = 0; i < 3; i++) {
        free(texts[i]);
    }
    result_free(&result);
}

Test(report_text, puts_a_title_below_that_does_not_fit)
{
    Result result = result_make("");
    Manifest long_titles = manifest;
    long_titles.tasks[0].title = "Does a circle cover the pixel, and is it nearer?";
    FILE *file = tmpfile();
    report_text(file, &long_titles, &result, (ReportTold){.is_all = 1}, 0);
    char *text = stream_text(file);
    expect_part(text, "\n Task overlaps_N_Nearer in overlaps_N_Nearer.cl:\n"
                      "   Does a circle cover the pixel, and is it nearer?       ");
    for (const char *line = text; *line != '\0'; line += strcspn(line, "\n") + 1) {
        cr_expect_leq(strcspn(line, "\n"), (size_t)96);
    }
    free(text);
    result_free(&result);
}

Test(report_text, keeps_a_compile_log_line_by_line)
{
    Result result = result_make("");
    result.stages[0].status = CHECK_FAILED;
    result.stages[0].message =
        strdup("a.cl:1:2: error: a very long line that is not wrapped because its "
               "carets point at columns of it\n    int x\n         ^\n");
    char *text = text_report(&result, 0);
    expect_part(text,
                "   FAIL  Compiling\n"
                "         a.cl:1:2: error: a very long line that is not wrapped because its carets "
                "point at columns of it\n"
                "             int x\n"
                "                  ^\n");
    free(text);
    result_free(&result);
}

Test(report_text, lets_no_message_reach_the_terminal_raw)
{
    Result result = result_make("\033[2J\033]0;pwned\007\x9B"
                                "31m");
    result.submission = "labs/\033[2J\nScore 100/100";
    char *text = text_report(&result, 0);
    expect_no_part(text, "\033");
    expect_no_part(text, "\007");
    expect_no_part(text, "\nScore 100/100");
    free(text);
    text = text_report(&result, 1);
    expect_part(text, "\033[31mFAIL\033[0m");
    expect_no_part(text, "\033[2J");
    free(text);
    result_free(&result);
}

Test(report_text, breaks_words_longer_than_a_line)
{
    char *message = repeated("x", 100000);
    Result result = result_make(message);
    char *text = text_report(&result, 0);
    for (const char *line = text; *line != '\0'; line += strcspn(line, "\n") + 1) {
        cr_expect_leq(strcspn(line, "\n"), (size_t)96);
    }
    cr_expect_leq(strlen(text), (size_t)11000);
    free(text);
    free(message);
    result_free(&result);
}

// ---- Messages and hints -------------------------------------------------------------------------

// What is wrong and the lab's hint are found together, in every report.
Test(report_hints, message_and_hint_stand_together)
{
    const char *message = "pixel (3, 2): found (1, 0, 0, 1), expected (0, 0, 1, 1), all swapped";
    Result result = result_make(message);
    char *texts[] = {text_report(&result, 0), file_report(report_html, &result),
                     file_report(report_json, &result)};
    for (int i = 0; i < 2; i++) {
        const char *says = strstr(texts[i], "all swapped");
        const char *hint = says ? strstr(says, "Compare the squares.") : NULL;
        const char *next_task = says ? strstr(says, "The nearest of all") : NULL;
        cr_expect(hint != NULL && next_task != NULL && hint < next_task, "%s", texts[i]);
        expect_no_part(texts[i], "Remember the depth.");  // nothing of that task has failed
    }
    expect_part(texts[2], message);
    expect_part(texts[2], "\"hint\": \"Compare the squares.\"");
    expect_no_part(texts[2], "Remember the depth.");
    for (int i = 0; i < 3; i++) {
        free(texts[i]);
    }
    result_free(&result);
}

// A message that has said why is not followed by a hint about something else.
Test(report_hints, no_hint_where_the_cause_is_named)
{
    Result result = result_make("found 1, expected 0");
    name_cause(&result.checks[1], "of two equal depths the later circle won");
    char *texts[] = {text_report(&result, 0), file_report(report_html, &result),
                     file_report(report_json, &result)};
    for (int i = 0; i < 3; i++) {
        expect_part(texts[i], "the later circle won");
        expect_no_part(texts[i], "Compare the squares.");
        free(texts[i]);
    }
    cr_expect_str_eq(check_hint(&manifest, &result, &result.checks[1]), "");
    result_free(&result);
}

// The first failed check decides; the hint is that of the check which has named the mistake.
Test(report_hints, the_hint_is_that_of_the_first_failed_check)
{
    static const Manifest hinted = {
        .lab = "01-naive-2d",
        .n_tasks = 1,
        .tasks = {{.id = "overlaps_N_Nearer",
                   .hint = "Of the task.",
                   .checks = {{.id = "overlaps-boundary", .hint = "Of the boundary."}},
                   .n_checks = 1}},
    };
    const Task *task = &hinted.tasks[0];
    Result result = result_make("found 0, expected 1");
    cr_expect_str_eq(task_hint(&hinted, &result, task), "Of the boundary.");
    result.checks[0].status = CHECK_FAILED;
    cr_expect_str_eq(task_hint(&hinted, &result, task), "Of the task.");
    cr_expect_str_eq(check_hint(&hinted, &result, &result.checks[1]), "Of the boundary.");
    name_cause(&result.checks[1], "strict where it should not be");
    cr_expect_str_eq(task_hint(&hinted, &result, task), "Of the boundary.");
    cr_expect_str_eq(check_hint(&hinted, &result, &result.checks[1]), "");
    result.checks[0].status = CHECK_PASSED;
    result.checks[1].status = CHECK_NOT_RUN;
    cr_expect_str_eq(task_hint(&hinted, &result, task), "");
    result_free(&result);
}
