// mutation/known_answer: what a file of known answers says, and which lines are refused.
#include "known_answer.h"
#include "surroundings.h"

TestSuite(known_file, .init = folder_enter, .fini = folder_leave);

static const Manifest manifest = {
    .lab = "01-x",
    .tasks = {{.id = "one",
               .file = "x.c",
               .checks = {{.id = "one-near"}, {.id = "one-far"}},
               .n_checks = 2},
              {.id = "two", .file = "x.c", .checks = {{.id = "two-near"}}, .n_checks = 1}},
    .n_tasks = 2,
};

static const char SOLUTION[] = "int one(int a)\n"
                               "{\n"
                               "    // TASK one: a\n"
                               "    //> return 0;\n"
                               "    return a;\n"
                               "    // END one\n"
                               "}\n"
                               "int two(int b)\n"
                               "{\n"
                               "    // TASK two: b and one\n"
                               "    //> return 0;\n"
                               "    b++;\n"
                               "    return b;\n"
                               "    // END two\n"
                               "}\n";

#define ONE "=== task one\n\n== check one-near\n\n"
#define HALF "wrong half: the half\nsays: a half|0.5\n-    return a;\n+    return a / 2;\n"

static KnownAnswers answers;

// Read the lab with a file of wrong answers and one of right ones; NULL: without. Returns a status.
static int read_files(const char *wrong, const char *right)
{
    static const char *const folders[] = {"solutions", "solutions/01-x", "tests", "tests/known",
                                          "tests/known/01-x"};
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        mkdir(folders[i], 0700);
    }
    file_write("solutions/01-x/x.c", SOLUTION, strlen(SOLUTION));
    if (wrong != NULL) {
        file_write("tests/known/01-x/wrong.diff", wrong, strlen(wrong));
    }
    if (right != NULL) {
        file_write("tests/known/01-x/right.diff", right, strlen(right));
    }
    return known_answers_read(&answers, &manifest);
}

// Is a file of wrong answers refused, with this message about this line?
static void expect_refused(const char *wrong, int line, const char *words)
{
    char place[64];
    snprintf(place, sizeof place, "tests/known/01-x/wrong.diff:%d: ", line);
    capture_begin(2);
    cr_expect_eq(read_files(wrong, NULL), -1, "%s", wrong);
    const char *said = capture_end(2);
    cr_expect_not_null(strstr(said, place), "found \"%s\", expected \"%s\"", said, place);
    cr_expect_not_null(strstr(said, words), "found \"%s\", expected \"%s\"", said, words);
    known_answers_free(&answers);
}

Test(known_file, all_that_it_says_is_read)
{
    cr_assert_eq(read_files("# Comment.\n" ONE HALF "\n"
                            "wrong all: more\n"
                            "says: more\n"
                            "never says: less\n"
                            "looks: gamma flipped-y\n"
                            "alone: passes, as nothing shows it\n"
                            "+    return 7;\n"
                            "=== task two\n"
                            "== check two-near\n"
                            "wrong twice: 2: twice\n"
                            "says: 2\n"
                            "-    b++;\n"
                            "\n"
                            "-    return b;\n"
                            "+    return b + b;\n",
                            "=== task two\nright c: c\n+    return b + 1;"),
                 0);
    cr_assert_eq(answers.n, 4);
    const KnownAnswer *half = &answers.all[0], *all = &answers.all[1];
    cr_expect_str_eq(half->name, "half");
    cr_expect_eq(half->line, 6);
    cr_expect_eq(half->task, &manifest.tasks[0]);
    cr_expect_eq(half->is_right, 0);
    cr_expect_str_eq(half->check, "one-near");
    cr_expect_str_eq(half->says, "a half|0.5");
    cr_expect_null(half->never);
    cr_expect_eq(half->mistakes, 0);
    cr_expect_eq(half->passes_alone, 0);
    cr_expect_str_eq(half->text, "    return a / 2;\n");
    cr_expect_str_eq(all->never, "less");
    cr_expect_eq(all->first_mistake, MISTAKE_GAMMA);
    cr_expect_eq(all->mistakes, 1u << MISTAKE_GAMMA | 1u << MISTAKE_FLIPPED_Y);
    cr_expect_eq(all->passes_alone, 1);
    cr_expect_str_eq(all->text, "    return 7;\n");
    cr_expect_str_eq(answers.all[2].name, "twice");
    cr_expect_str_eq(answers.all[2].text, "    return b + b;\n");
    cr_expect_eq(answers.all[3].is_right, 1);
    cr_expect_str_eq(answers.all[3].text, "    return b + 1;\n");
    cr_expect_eq(known_answers_find(&answers, "c"), &answers.all[3]);
    cr_expect_null(known_answers_find(&answers, "d"));
    known_answers_keep(&answers, "al");
    cr_expect_eq(answers.n, 2);
    cr_expect_str_eq(answers.all[1].name, "all");
    known_answers_free(&answers);
}

Test(known_file, a_lab_may_have_none)
{
    cr_expect_eq(read_files(NULL, NULL), 0);
    cr_expect_eq(answers.n, 0);
    known_answers_free(&answers);
}

Test(known_file, an_edit_that_does_not_fit_is_named)
{
    expect_refused(ONE HALF "\nwrong b: b\nsays: b\n\n-    return b;\n+    return 0;\n", 13,
                   "one, b: the edit does not fit");
    expect_refused(ONE "wrong b: b\nsays: b\n", 5, "one, b: no edit");
    expect_refused(ONE "wrong b: b\nsays: b\n-    b\n\nwrong c: c\nsays: c\n-    c\n", 7,
                   "wrong.diff:11: one, c: the edit does not fit");
    expect_refused(ONE "wrong b: b\nsays: b\n-    return a;\n+    return a;\n", 7,
                   "changes nothing");
}

Test(known_file, the_placeholder_is_not_the_solutions)
{
    expect_refused(ONE "wrong b: b\nsays: b\n-    //> return 0;\n", 7, "does not fit");
}

Test(known_file, unknown_names_are_named)
{
    expect_refused("=== task three\n", 1, "no task of the lab is called three");
    expect_refused("=== task two\n== check one-near\n", 2,
                   "no check of task two is called one-near");
    expect_refused("== check one-near\n", 1, "no check of task (none)");
    expect_refused(ONE "wrong b: b\nlooks: grey\n", 6, "no kind of mistake is called \"grey\"");
}

Test(known_file, what_is_missing_is_named)
{
    expect_refused(HALF, 1, "before the heading");
    expect_refused("=== task one\n" HALF, 2, "before the heading");
    expect_refused(ONE "wrong half\n", 5, "expected \"wrong name: what it does\"");
    expect_refused(ONE "wrong b: b\n+    return 1;\n" HALF, 5, "b: no line \"says: ...\"");
    expect_refused("+    return 1;\n", 1, "belongs to no answer");
    expect_refused(ONE HALF "# Comment.\n+    return 1;\n", 10, "belongs to no answer");
}

Test(known_file, what_is_there_twice_is_named)
{
    expect_refused(ONE HALF HALF, 9, "a second answer called half");
    expect_refused(ONE "wrong b: b\nsays: b\nsays: c\n", 7, "each once");
}

Test(known_file, lines_that_say_nothing_are_named)
{
    expect_refused(ONE "wrong b: b\nsais: b\n", 6, "found \"sais: b\"");
    expect_refused(ONE HALF "looks: gamma\n", 9, "expected a heading");
    expect_refused(ONE "right b: b\n", 5, "found \"right b: b\"");
    expect_refused(ONE "wrong b: b\nsays: b\nalone: fails\n", 7, "found \"alone: fails\"");
}

Test(known_file, right_answers_have_no_check)
{
    capture_begin(2);
    cr_expect_eq(read_files(NULL, ONE "right c: c\n+    return 1;\n"), -1);
    cr_expect_not_null(strstr(capture_end(2), "right.diff:3: found \"== check one-near\""));
    known_answers_free(&answers);
}
