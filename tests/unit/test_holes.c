// grader/holes: cutting skeletons, reading a student's answer, putting it into the solution.
#include "holes.h"
#include "random.h"
#include "surroundings.h"
#include "text_file.h"

#include <criterion/redirect.h>
#include <glob.h>

TestSuite(holes);

static const char SOLUTION[] = "int one(void)\n"
                               "{\n"
                               "    // TASK one: say one.\n"
                               "    // In one line.\n"
                               "    //> (void)0;\n"
                               "    //>\n"
                               "    //>     return 0;\n"
                               "    const int n = 1;\n"
                               "    // The solution's own comment.\n"
                               "    return n;\n"
                               "    // END one\n"
                               "}\n"
                               "// TASK two: nothing.\n"
                               "//> // (your code)\n"
                               "code();  // TASK three: not at the start of the line\n"
                               "// END two\n"
                               "tail\n";

static const char SKELETON[] = "int one(void)\n"
                               "{\n"
                               "    // TASK one: say one.\n"
                               "    // In one line.\n"
                               "    (void)0;\n"
                               "\n"
                               "        return 0;\n"
                               "    // END one\n"
                               "}\n"
                               "// TASK two: nothing.\n"
                               "// (your code)\n"
                               "// END two\n"
                               "tail\n";

// Compare a text that is to be freed.
static void expect_text(char *found, const char *expected)
{
    cr_expect(found != NULL && strcmp(found, expected) == 0, "found \"%s\", expected \"%s\"",
              found ? found : "(nothing)", expected);
    free(found);
}

// ---- Cutting ------------------------------------------------------------------------------------

Test(holes, a_skeleton_has_placeholders_for_solutions)
{
    expect_text(holes_cut(SOLUTION, "a.c"), SKELETON);
}

Test(holes, what_has_no_hole_stays_as_it_is)
{
    static const char *const texts[] = {"",
                                        "\n",
                                        "\n\n a\n",
                                        "// TASKS a\n",
                                        "// TASK \n",
                                        "// TASK : no id\n",
                                        "x // TASK a: behind code\n",
                                        "//TASK a: no blank\n",
                                        "// ENDING a\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        expect_text(holes_cut(texts[i], "a.c"), texts[i]);
        char id[HOLE_ID_BYTES];
        cr_expect_eq(hole_id(texts[i], 0, id), 0);
        cr_expect_null(hole_read(texts[i], "a"));
        cr_expect_null(hole_fill(texts[i], "a", "b\n"));
    }
}

Test(holes, a_last_line_without_newline_gets_one)
{
    expect_text(holes_cut("tail", "a.c"), "tail\n");
    expect_text(holes_cut("// TASK a:\n//> b\nc\n// END a", "a.c"), "// TASK a:\nb\n// END a\n");
}

Test(holes, lines_may_end_in_carriage_returns)
{
    const char text[] = "// TASK a: b\r\n  //> c\r\nd\r\n// END a\r\n";
    expect_text(holes_cut(text, "a.c"), "// TASK a: b\r\n  c\r\n// END a\r\n");
    expect_text(hole_read(text, "a"), "  //> c\r\nd\r\n");
    expect_text(hole_fill(text, "a", "e\n"), "// TASK a: b\r\ne\n// END a\r\n");
}

Test(holes, what_is_no_hole_is_refused_with_its_line)
{
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"a\n// TASK a: b\n//> c\nd\n", "a.c:4: a TASK without its END"},
        {"// TASK a: b", "a.c:1: a TASK without its END"},
        {"// END a\n", "a.c:1: END without its TASK"},
        {"// TASK a: b\n//> c\n// END a\n// END a\n", "a.c:4: END without its TASK"},
        {"// TASK a: b\n//> c\n// END b\n", "a.c:3: END without its TASK"},
        {"// TASK a: b\n//> c\n// TASK b: d\n//> e\n// END b\n// END a\n",
         "a.c:3: a TASK inside a task"},
        {"// TASK a: b\n//> c\n// TASK a: b\n// END a\n", "a.c:3: a TASK inside a task"},
        {"// TASK a: b\n// c\nd\n\t// END a\n", "a.c:4: a task without a //> placeholder"},
        {"// TASK a: b\n//> c\n// END a\n// TASK b: c\n// END b",
         "a.c:5: a task without a //> placeholder"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        capture_begin(2);
        char *skeleton = holes_cut(cases[i].text, "a.c");
        expect_one_message(capture_end(2), cases[i].message);
        cr_expect_null(skeleton, "case %zu", i);
        free(skeleton);
    }
}

// ---- Ids ----------------------------------------------------------------------------------------

Test(holes, are_listed_in_order)
{
    char id[HOLE_ID_BYTES];
    cr_expect(hole_id(SOLUTION, 0, id));
    cr_expect_str_eq(id, "one");
    cr_expect(hole_id(SOLUTION, 1, id));
    cr_expect_str_eq(id, "two");
    cr_expect_eq(hole_id(SOLUTION, 2, id), 0);
    cr_expect_eq(hole_id("", 0, id), 0);
    cr_expect(hole_id("\t// TASK last", 0, id), "without newline, without colon");
    cr_expect_str_eq(id, "last");
}

Test(holes, an_id_is_never_cut_short)
{
    for (int length = HOLE_ID_BYTES - 2; length <= HOLE_ID_BYTES + 1; length++) {
        char long_id[2 * HOLE_ID_BYTES] = {0}, text[512], id[HOLE_ID_BYTES];
        memset(long_id, 'i', (size_t)length);
        snprintf(text, sizeof text, "// TASK %s: a\n//> b\nc\n// END %s\n", long_id, long_id);
        const int fits = length < HOLE_ID_BYTES;
        cr_expect_eq(hole_id(text, 0, id), fits, "%d bytes", length);
        char *body = hole_read(text, long_id);
        cr_expect_eq(body != NULL, fits, "%d bytes", length);
        free(body);
    }
}

// ---- Reading and filling ------------------------------------------------------------------------

Test(holes, reading_takes_what_follows_the_task_text)
{
    expect_text(hole_read(SOLUTION, "two"),
                "//> // (your code)\n"
                "code();  // TASK three: not at the start of the line\n");
    expect_text(hole_read(SKELETON, "one"), "    (void)0;\n\n        return 0;\n");
    expect_text(hole_read("// TASK a: b\n// END a", "a"), "");
    expect_text(hole_read("// TASK a: b\n// c\n// END a", "a"), "");
    cr_expect_null(hole_read(SOLUTION, "three"));
    cr_expect_null(hole_read(SOLUTION, "on"), "the begin of an id is another id");
    cr_expect_null(hole_read(SOLUTION, ""));
}

Test(holes, a_line_stands_in_a_hole_or_not)
{
    static const int lines_of_one[] = {0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0};
    const int n = (int)(sizeof lines_of_one / sizeof *lines_of_one);
    for (int i = 0; i < n; i++) {
        cr_expect_eq(hole_has_line(SOLUTION, "one", i + 1), lines_of_one[i], "line %d", i + 1);
    }
    cr_expect_eq(hole_has_line(SOLUTION, "two", 15), 1);
    cr_expect_eq(hole_has_line(SOLUTION, "one", 0), 0);
    cr_expect_eq(hole_has_line(SOLUTION, "one", 1000), 0);
    cr_expect_eq(hole_has_line(SOLUTION, "three", 5), 0);
}

Test(holes, filling_replaces_solution_and_placeholder)
{
    expect_text(hole_fill(SOLUTION, "two", "other();"), "int one(void)\n"
                                                        "{\n"
                                                        "    // TASK one: say one.\n"
                                                        "    // In one line.\n"
                                                        "    //> (void)0;\n"
                                                        "    //>\n"
                                                        "    //>     return 0;\n"
                                                        "    const int n = 1;\n"
                                                        "    // The solution's own comment.\n"
                                                        "    return n;\n"
                                                        "    // END one\n"
                                                        "}\n"
                                                        "// TASK two: nothing.\n"
                                                        "other();\n"
                                                        "// END two\n"
                                                        "tail\n");
    expect_text(hole_fill("// TASK a: b\n//> c\n// END a", "a", ""), "// TASK a: b\n// END a");
    cr_expect_null(hole_fill(SOLUTION, "three", ""));
    cr_expect_null(hole_fill("", "one", "a"));
}

// A submission may hold anything; which of two answers would count?
Test(holes, markers_that_are_not_there_once_each_in_order_hold_no_answer)
{
    static const char *const texts[] = {
        "// TASK a: b\nc\n// END a\n// TASK a: b\nd\n// END a\n",
        "// TASK a: b\n// TASK a: b\nc\n// END a\n",
        "// TASK a: b\nc\n// END a\nd\n// END a\n",
        "// END a\n// TASK a: b\nc\n// END a\n",
        "// END a\n// TASK a: b\nc\n",
        "// TASK a: b\nc\n",
        "// END a\n",
        "// TASK a: b",
        "// TASK a: b\nc\n// END b\n",
        "// TASK a: b\nc\nd(); // END a\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        char *body = hole_read(texts[i], "a"), *filled = hole_fill(texts[i], "a", "e\n");
        cr_expect_null(body, "text %zu was read", i);
        cr_expect_null(filled, "text %zu was filled", i);
        free(body);
        free(filled);
    }
}

// What holds for any text with a hole `id` that can be read.
static void expect_read_and_fill_agree(const char *text, const char *id)
{
    char *body = hole_read(text, id);
    if (body == NULL) {
        cr_expect_null(hole_fill(text, id, ""));
        return;
    }
    expect_text(hole_fill(text, id, body), text);
    char *filled = hole_fill(text, id, "answer();\n//> none\n");
    cr_assert_not_null(filled);
    expect_text(hole_read(filled, id), "answer();\n//> none\n");
    expect_text(hole_fill(filled, id, body), text);
    free(filled);
    free(body);
}

Test(holes, any_text_is_handled, .init = cr_redirect_stderr)
{
    static const char *const lines[] = {
        "// TASK a: b\n", "// TASK b: c\r\n", "  // END a\n", "// END b\n", "\t//> d\n",
        "//>\n",          "// e\n",           "f();\n",       "\n",         "// TASK",
        "// TASK a",      "// END a",         "//> g",        "\r",         "//"};
    Random random = {1};
    int n_cut = 0;
    for (int round = 0; round < 20000; round++) {
        char text[512] = "", id[HOLE_ID_BYTES], cut_id[HOLE_ID_BYTES];
        for (int64_t n = random_integer(&random, 0, 9); n > 0; n--) {
            strcat(text, lines[random_integer(&random, 0, sizeof lines / sizeof *lines - 1)]);
        }
        expect_read_and_fill_agree(text, "a");
        expect_read_and_fill_agree(text, "b");
        char *skeleton = holes_cut(text, "text");
        if (skeleton == NULL) {
            continue;
        }
        n_cut++;
        for (int i = 0; hole_id(text, i, id); i++) {
            cr_expect(hole_id(skeleton, i, cut_id) && strcmp(id, cut_id) == 0, "%s", text);
        }
        free(skeleton);
    }
    cr_expect(n_cut > 1000 && n_cut < 19000, "%d", n_cut);
}

// ---- The course's own ---------------------------------------------------------------------------

static int n_holes_checked;

static void expect_cuts(const char *path)
{
    char *solution = text_file_read(path);
    cr_assert_not_null(solution);
    char *skeleton = holes_cut(solution, path);
    cr_assert_not_null(skeleton, "%s", path);
    cr_expect_null(strstr(skeleton, "//>"), "%s: a placeholder's mark is left", path);
    char id[HOLE_ID_BYTES];
    for (int i = 0; hole_id(solution, i, id); i++, n_holes_checked++) {
        expect_read_and_fill_agree(solution, id);
        char *answer = hole_read(solution, id), *placeholder = hole_read(skeleton, id);
        cr_assert(answer != NULL && placeholder != NULL, "%s: %s", path, id);
        cr_expect_str_neq(answer, placeholder);
        // A student's work: the answer goes into the skeleton, and from there into the solution.
        char *submission = hole_fill(skeleton, id, answer);
        expect_text(hole_read(submission, id), answer);
        char *refilled = hole_fill(solution, id, answer);
        expect_text(holes_cut(refilled, path), skeleton);
        free(refilled);
        free(submission);
        free(answer);
        free(placeholder);
    }
    free(skeleton);
    free(solution);
}

Test(holes, every_file_of_the_solutions_cuts)
{
    glob_t files;
    cr_assert_eq(glob("solutions/*/*.[hc]*", 0, NULL, &files), 0, "start in the top folder");
    for (size_t i = 0; i < files.gl_pathc; i++) {
        expect_cuts(files.gl_pathv[i]);
    }
    cr_expect_geq(n_holes_checked, 15);
    globfree(&files);
}

static void expect_fault(const char *text, const char *expected)
{
    char *fault = hole_fault(text, "one");
    if (expected == NULL) {
        cr_expect_null(fault, "%s", fault);
    } else {
        cr_expect_str_eq(fault ? fault : "", expected);
    }
    free(fault);
}

Test(holes, a_lost_marker_is_told_with_its_line)
{
    expect_fault("a\n// TASK one: b\nc\n// END one\n", NULL);
    expect_fault("a\n// TASK one: b\nc\n",
                 "line 2: \"// TASK one\", but no line \"// END one\" behind it");
    expect_fault("a\n// TASK on: b\nc\n// END one\n",
                 "line 4: \"// END one\", but no line \"// TASK one\" before it");
    expect_fault("a\n", "the lines \"// TASK one\" and \"// END one\" are missing");
    expect_fault("// END one\n// TASK one: b\n",
                 "line 1: \"// END one\" stands before \"// TASK one\"");
    expect_fault("// TASK one: b\n// END one\n// END one\n",
                 "line 3: \"// END one\" stands there a second time");
}
