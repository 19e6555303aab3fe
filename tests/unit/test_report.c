// Unit tests of the reports: whatever a student's code put into a message, each report stays whole,
// and what was judged comes out unchanged.
#include "clean_text.h"
#include "graded.h"
#include "hints.h"
#include "report.h"
#include "sample_result.h"

#include <criterion/criterion.h>
#include <criterion/redirect.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// The whole of a stream or file, with its length; free() it.
static char *stream_text(FILE *file)
{
    fseek(file, 0, SEEK_END);
    long length = ftell(file);
    rewind(file);
    char *text = calloc(1, (size_t)length + 1);
    cr_assert_eq(fread(text, 1, (size_t)length, file), (size_t)length);
    fclose(file);
    return text;
}

static char *text_report(const Result *result, int colours)
{
    FILE *file = tmpfile();
    cr_assert_eq(report_text(file, &manifest, result, colours), 0);
    return stream_text(file);
}

typedef int Report(const char *path, const Manifest *manifest, const Result *result);

// What a report writes to a file.
static char *file_report(Report *report, const Result *result)
{
    char folder[] = "/tmp/test-report-XXXXXX";
    cr_assert_not_null(mkdtemp(folder));
    char path[64];
    snprintf(path, sizeof path, "%s/report", folder);
    cr_assert_eq(report(path, &manifest, result), 0);
    char *text = stream_text(fopen(path, "rb"));
    unlink(path);
    cr_expect_eq(rmdir(folder), 0, "something else was left in the folder");
    return text;
}

static void expect_part(const char *text, const char *part)
{
    cr_expect(strstr(text, part) != NULL, "expected \"%s\" in:\n%s", part, text);
}

static void expect_no_part(const char *text, const char *part)
{
    cr_expect(strstr(text, part) == NULL, "expected no \"%s\" in:\n%s", part, text);
}

// ---- Cleaning ----------------------------------------------------------------------------------

#define UNKNOWN "\xEF\xBF\xBD"

Test(clean_text, keeps_what_can_be_shown_and_replaces_the_rest)
{
    static const char *const pairs[][2] = {
        {"plain text", "plain text"},
        {"distance\xC2\xB2 <= radius\xC2\xB2", "distance\xC2\xB2 <= radius\xC2\xB2"},
        {"\xF0\x9F\x98\x80", "\xF0\x9F\x98\x80"},
        {"two\n\tlines\n\n", "two\n\tlines"},
        {"two\r\nlines", "two\nlines"},
        {"back\r", "back" UNKNOWN},
        {"\033[2Jgone", UNKNOWN "[2Jgone"},
        {"\x7F\x08\x07", UNKNOWN UNKNOWN UNKNOWN},
        {"\xC2\x9B"
         "2J",
         UNKNOWN "2J"},  // C1 control sequence introducer
        {"a\xE2\x80\xAE"
         "b",
         "a" UNKNOWN "b"},  // right-to-left override
        {"\xFF\xFE", UNKNOWN UNKNOWN},
        {"\xC3", UNKNOWN},                                      // broken off
        {"\xC0\xAF", UNKNOWN UNKNOWN},                          // longer than needed
        {"\xED\xA0\x80", UNKNOWN UNKNOWN UNKNOWN},              // half of a surrogate pair
        {"\xF4\x90\x80\x80", UNKNOWN UNKNOWN UNKNOWN UNKNOWN},  // beyond U+10FFFF
        {"", ""},
        {NULL, ""},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        char *clean = message_clean(pairs[i][0]);
        cr_expect_str_eq(clean, pairs[i][1], "pair %zu: found \"%s\"", i, clean);
        free(clean);
    }
    char *line = line_clean("a\tb\nc");
    cr_expect_str_eq(line, "a b c");
    free(line);
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

Test(clean_text, shortens_a_long_message_in_the_middle)
{
    char *text = repeated("\xE2\x82\xAC", 40000);
    text[0] = 'A', text[1] = 'B', text[2] = 'C';
    char *clean = message_clean(text);
    cr_expect_leq(strlen(clean), (size_t)MESSAGE_MAX_BYTES);
    cr_expect_eq(strncmp(clean, "ABC\xE2\x82\xAC", 6), 0);
    expect_part(clean, " bytes left out ...] \xE2\x82\xAC");
    // Cut between characters: cleaning again changes nothing.
    char *again = message_clean(clean);
    cr_expect_str_eq(again, clean);
    free(again);
    free(clean);
    clean = line_clean(text);
    cr_expect_leq(strlen(clean), (size_t)LINE_MAX_BYTES + 64);
    free(clean);
    free(text);
}

Test(clean_text, shortens_many_lines_to_forty)
{
    for (int n_lines = 38; n_lines <= 300; n_lines += n_lines < 45 ? 1 : 51) {
        char text[8192] = "";
        for (int i = 1; i <= n_lines; i++) {
            sprintf(text + strlen(text), "line %d\n", i);
        }
        char *clean = message_clean(text);
        char last[32];
        snprintf(last, sizeof last, "\nline %d", n_lines);
        int n_kept = 1;
        for (const char *at = clean; (at = strchr(at, '\n')) != NULL; at++) {
            n_kept++;
        }
        cr_expect_eq(n_kept, n_lines < 40 ? n_lines : 40);
        cr_expect_str_eq(clean + strlen(clean) - strlen(last), last);
        expect_part(clean, "line 29\n");
        if (n_lines == 299) {
            expect_part(clean, "line 29\n[... 260 lines left out ...]\nline 290\n");
        }
        free(clean);
    }
}

// ---- The text report ---------------------------------------------------------------------------

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
        " Score 25/100\n",
        "found:\n%s", text);
    free(text);
    result_free(&result);
}

Test(report_text, puts_a_title_below_that_does_not_fit)
{
    Result result = result_make("");
    Manifest long_titles = manifest;
    long_titles.tasks[0].title = "Does a circle cover the pixel, and is it nearer?";
    FILE *file = tmpfile();
    cr_assert_eq(report_text(file, &long_titles, &result, 0), 0);
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
    strcpy(result.submission, "labs/\033[2J\nScore 100/100");
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

// What is wrong and the lab's hint are found together, in every report.
Test(report, message_and_hint_stand_together)
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
Test(report, no_hint_where_the_cause_is_named)
{
    Result result = result_make("found 1, expected 0; of two equal depths the later circle won");
    cr_assert(result.checks[1].is_explained);
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

// The first failed check decides, and what one check has explained holds for its whole task.
Test(report, the_hint_is_that_of_the_first_failed_check)
{
    static const Manifest hinted = {
        .lab = "01-naive-2d",
        .n_tasks = 1,
        .tasks = {{.id = "overlaps_N_Nearer",
                   .hint = "Of the task.",
                   .hints = {{"overlaps-boundary", "Of the boundary."}},
                   .n_hints = 1}},
    };
    const Task *task = &hinted.tasks[0];
    Result result = result_make("found 0, expected 1");
    cr_expect_str_eq(task_hint(&hinted, &result, task), "Of the boundary.");
    result.checks[0].status = CHECK_FAILED;
    cr_expect_str_eq(task_hint(&hinted, &result, task), "Of the task.");
    cr_expect_str_eq(check_hint(&hinted, &result, &result.checks[1]), "Of the boundary.");
    result.checks[1].is_explained = 1;
    cr_expect_str_eq(task_hint(&hinted, &result, task), "");
    result.checks[0].status = CHECK_PASSED;
    result.checks[1].status = CHECK_NOT_RUN;
    cr_expect_str_eq(task_hint(&hinted, &result, task), "");
    result_free(&result);
}

// ---- results.json ------------------------------------------------------------------------------

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
        "\"quoted\" \\ " UNKNOWN " " UNKNOWN " end", "hint", "Compare the squares.", "id",
        "picture", "title", "A random scene", "task", "implicit2DRenderer", "points", 0,
        "max_points", 60, "status", "not-run", "message", "", "hint", "");
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
    cr_expect_eq(access("/tmp/test-report-never-written.json", F_OK), -1);
    result_free(&result);
}

// ---- Reading results.json back -----------------------------------------------------------------

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
        const char *at = strstr(text, edits[i][0]);
        cr_assert_not_null(at, "edit %zu", i);
        char edited[8192];
        snprintf(edited, sizeof edited, "%.*s%s%s", (int)(at - text), text, edits[i][1],
                 at + strlen(edits[i][0]));
        Graded graded;
        cr_expect_eq(graded_load_text(edited, &graded), -1, "edit %zu was taken", i);
        cr_expect_null(graded.json);
    }
    Graded graded;
    cr_expect_eq(graded_load("/dev/zero", &graded), -1);
    cr_expect_eq(graded_load("/nowhere/results.json", &graded), -1);
    free(text);
    result_free(&result);
}

// ---- The page ----------------------------------------------------------------------------------

Test(report_html, escapes_every_message)
{
    Result result = result_make("<script>alert('1')</script> & \"quotes\" \x01 \xFF </p>");
    result.stages[0].message = strdup("<img src=x onerror=alert(1)>\n</pre><b>");
    strcpy(result.submission, "labs/\"><script>");
    strcpy(result.device, "<svg onload=x>");
    result.n_pictures = 1;
    strcpy(result.pictures[0].title, "</h3><script>");
    char *page = file_report(report_html, &result);
    static const char *const never[] = {"<script", "<img", "<b>evil", "<svg",
                                        "\x01",    "\xFF", "</p> <",  "&lt;/p></p>"};
    for (size_t i = 0; i < sizeof never / sizeof never[0]; i++) {
        expect_no_part(page, never[i]);
    }
    expect_part(page,
                "&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt; &amp; &quot;quotes&quot; " UNKNOWN
                " " UNKNOWN " &lt;/p&gt;</p>");
    expect_part(
        page, "<pre class=\"log\">&lt;img src=x onerror=alert(1)&gt;\n&lt;/pre&gt;&lt;b&gt;</pre>");
    expect_part(page, "Compare the squares.");
    expect_no_part(page, "Remember the depth.");
    free(page);
    result_free(&result);
}

static Image picture_make(int width, float value)
{
    Image image;
    cr_assert_eq(image_create(width, 2, &image), 0);
    image.pixels[0] = value;
    return image;
}

static int count_parts(const char *text, const char *part)
{
    int n = 0;
    for (const char *at = text; (at = strstr(at, part)) != NULL; at++) {
        n++;
    }
    return n;
}

Test(report_html, embeds_pictures_and_refers_to_nothing_outside)
{
    static const char svg[] = "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>";
    Result result = result_make("wrong");
    result.n_pictures = 4;
    result.pictures[0] = (PictureResult){.title = "both"};
    result.pictures[0].reference = picture_make(3, 1);
    result.pictures[0].own = picture_make(3, 0);
    result.pictures[1] = (PictureResult){.title = "sizes"};
    result.pictures[1].reference = picture_make(3, 1);
    result.pictures[1].own = picture_make(4, 1);
    result.pictures[2] = (PictureResult){.title = "none", .reference = picture_make(3, 1)};
    result.pictures[3] = (PictureResult){.title = "tree", .svg_reference = strdup(svg)};
    char *page = file_report(report_html, &result);
    cr_expect_eq(count_parts(page, "src=\"data:image/png;base64,iVBORw0KGgo"), 3 + 2 + 1);
    cr_expect_eq(count_parts(page, "src=\"data:image/svg+xml;base64,PHN2Zy"), 1);
    cr_expect_eq(count_parts(page, "src="), 3 + 2 + 1 + 1);
    expect_part(page, "the reference is 3&times;2, yours 4&times;2");
    // The difference has a legend, and nothing else has.
    cr_expect_eq(count_parts(page, "<div class=\"legend\">"), 1);
    expect_part(page, "linear-gradient(to right, #000004, ");
    expect_part(page, ", #fcffa4)");
    expect_part(page, "<span>0</span><span>0.125</span><span>0.25</span><span>0.375</span>"
                      "<span>&ge; 0.5</span>");
    expect_part(page, "content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\"");
    expect_no_part(page, "http:");
    expect_no_part(page, "https:");
    expect_no_part(page, "<script");
    expect_no_part(page, "url(");
    expect_no_part(page, "@import");
    free(page);
    result_free(&result);
}

Test(report_html, leaves_the_old_page_when_it_cannot_be_written, .init = cr_redirect_stderr)
{
    Result result = result_make("wrong");
    cr_expect_eq(report_html("/nowhere/report.html", &manifest, &result), -1);
    cr_expect_eq(report_html("/dev/null", &manifest, &result), -1);
    result_free(&result);
}
