// grader/stands_out: what an attack tries is named, and no honest text is.
#include "known_answer.h"
#include "stands_out.h"
#include "surroundings.h"

#include "text_file.h"

#include <glob.h>

TestSuite(stands_out);

// The notes on a text, owned by the caller.
static char *notes_on(const char *text)
{
    char *notes = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&notes, &n_bytes);
    stands_out_in_text("a.c", text, file);
    fclose(file);
    return notes;
}

static const struct {
    const char *text, *note;
} striking[] = {
    {"int f(void)\n{\n    return fork();\n}", "a.c:3: fork(): "},
    {"fo\\\nrk /* really */ ()", "a.c:1: fork(): "},
    {"\\\n\n/*\n*/ // x\\\n\nsystem(\"id\");", "a.c:6: system(): "},
    {"exit(0);", "exit(0)"},
    {"exit ( EXIT_SUCCESS );", "exit(0)"},
    {"_exit(3);", "_exit()"},
    {"__attribute__((constructor)) static void f(void)", "the attribute constructor"},
    {"__attribute__((unused, constructor(101)))", "the attribute constructor"},
    {"__asm__ volatile(\"syscall\")", "asm"},
    {"int main(void)", "a function called main"},
    {"#include <unistd.h>", "#include <unistd.h>"},
    {"  #  include \"/etc/passwd\"", "#include \"/etc/passwd\""},
    {"#include \"../neighbour/answer.c\"", "#include \"../neighbour/answer.c\""},
    {"#include SOME_NAME", "#include \"SOME_NAME\""},
    {"#if __has_include(\"x\")", "__has_include()"},
    {"#line 1 \"x\"", "#line"},
    {"# 1 \"x\"", "#1"},
    {"#pragma GCC dependency \"x\"", "the pragma GCC dependency"},
    {"_Pragma(\"GCC dependency \\\"x\\\"\")", "the pragma GCC dependency"},
    {"f = \"/etc/shadow\";", "\"/etc/shadow\""},
    {"f = \"out/answers\";", "\"out/answers\""},
    {"asm(\"x: .incbin \\\"y\\\"\");", ".incbin"},
    {"work->n_tests = 1;", "a hand on the counted work (work)"},
    {"work.n_tests = 1;", "a hand on the counted work (work)"},
    {"Work aside = {0};", "a count of its own (Work aside)"},
    {"d_work[0].n_tests = 1;", "a hand on the counted work (d_work)"},
    {"char c = '\"'; fork();", "fork()"},
    {"char c = '\\''; fork();", "fork()"},
    {"char *c = \"an open string\nfork();", "a.c:2: fork()"},
    {"#error don't\nfork();", "a.c:2: fork()"},
    {"fork (", "fork()"},
    {"%:include \"/etc/passwd\"", "#include \"/etc/passwd\""},
    {"?\?=include \"/etc/passwd\"", "#include \"/etc/passwd\""},
    {"fo?\?/\nrk()", "fork()"},
    {"fo\\ \t\nrk()", "fork()"},
};

Test(stands_out, names_what_is_tried)
{
    for (size_t i = 0; i < sizeof striking / sizeof *striking; i++) {
        char *notes = notes_on(striking[i].text);
        cr_expect_not_null(strstr(notes, striking[i].note), "found \"%s\" on \"%s\"", notes,
                           striking[i].text);
        free(notes);
    }
}

static const char *const honest[] = {
    "",
    "// fork()\n/* exit(0); \" */ int x; // system(\"x\") \\\nfork() is still a comment",
    "const char *text = \"fork(); /etc is far\";",
    "builder->open(x); list.kill(y);",
    "int fork, open; open = fork;",
    "if (ids == NULL) { exit(1); }",
    "abort(); assert(x); printf(\"%d\", getenv(\"X\"));",
    "#include <stdio.h>\n#include <CL/cl.h>\n#include \"circle.h\"\n#include "
    "\"../../kernels/ray.h\"",
    "#define constructor 1\nint constructor_of(void);",
    "__attribute__((reqd_work_group_size(16, 16, 1))) kernel void f(global int *out)",
    "int work = 3; work--; f(work);",
    "#pragma once\n#pragma unroll\n#pragma OPENCL EXTENSION cl_khr_fp64 : enable",
    "int main_menu(void); x = domain(3);",
    "a / b / c; a /*/ b(); */ c",
};

Test(stands_out, honest_texts_do_not)
{
    for (size_t i = 0; i < sizeof honest / sizeof *honest; i++) {
        char *notes = notes_on(honest[i]);
        cr_expect_str_eq(notes, "", "found \"%s\" on \"%s\"", notes, honest[i]);
        free(notes);
    }
}

// Expect that nothing is said of a text, and count it.
static void expect_nothing(const char *text, const char *name, int *n_texts)
{
    char *notes = notes_on(text);
    cr_expect_str_eq(notes, "", "%s: %s", name, notes);
    free(notes);
    ++*n_texts;
}

// A solution or a skeleton is no attack. main.c and what it calls is never handed in.
Test(stands_out, nothing_of_the_course_does)
{
    int n_files = 0;
    glob_t found = {0};
    glob("{solutions,labs}/*/*.c*", GLOB_BRACE, NULL, &found);
    for (size_t k = 0; k < found.gl_pathc; k++) {
        const char *path = found.gl_pathv[k];
        if (strstr(path, "/main.c") == NULL && strstr(path, "/circles.c") == NULL) {
            char *text = text_file_read(path);
            expect_nothing(text, path, &n_files);
            free(text);
        }
    }
    globfree(&found);
    cr_expect_gt(n_files, 30, "found %d files: not started from the top folder?", n_files);
}

// Nor is a student's mistake; who forges or hides counted work makes none.
Test(stands_out, no_known_answer_does)
{
    static KnownAnswers answers;
    int n_answers = 0;
    glob_t found = {0};
    glob(KNOWN_FOLDER "/[0-9]*", 0, NULL, &found);
    for (size_t k = 0; k < found.gl_pathc; k++) {
        Manifest manifest;
        cr_assert_eq(manifest_load("solutions", strrchr(found.gl_pathv[k], '/') + 1, &manifest), 0);
        cr_assert_eq(known_answers_read(&answers, &manifest), 0);
        for (int i = 0; i < answers.n; i++) {
            const char *name = answers.all[i].name;
            if (strstr(name, "forged") == NULL && strstr(name, "work-of-its-own") == NULL &&
                strstr(name, "hidden-") == NULL) {
                expect_nothing(answers.all[i].text, name, &n_answers);
            }
        }
        known_answers_free(&answers);
        manifest_free(&manifest);
    }
    globfree(&found);
    cr_expect_gt(n_answers, 1000, "found %d answers: not started from the top folder?", n_answers);
}

Test(stands_out, is_short_and_says_each_thing_once)
{
    char *once = notes_on("fork();\nfork();\n");
    cr_expect_str_eq(once, "a.c:1: fork(): no answer needs it\n");
    free(once);

    char *notes = NULL;
    size_t n_bytes;
    FILE *text = open_memstream(&notes, &n_bytes);
    for (int i = 0; i < 1000; i++) {
        fprintf(text, "\"/etc/%d\";\n", i);
    }
    fclose(text);
    char *few = notes_on(notes);
    cr_expect_lt(strlen(few), 1000);
    free(few);
    free(notes);
}

// ---- What else was handed in --------------------------------------------------------------------

static Manifest manifest_02(void)
{
    return (Manifest){.lab = "02-kdtree-2d-build", .files = {"kdtree2d_build.c"}, .n_files = 1};
}

// A folder with a lab and the submission "own", which holds the answer.
static void lab_enter(void)
{
    folder_enter();
    mkdir("labs", 0755);
    mkdir("labs/02-kdtree-2d-build", 0755);
    mkdir("own", 0755);
    static const char *const files[] = {"labs/02-kdtree-2d-build/lab.json",
                                        "labs/02-kdtree-2d-build/README.md",
                                        "own/kdtree2d_build.c"};
    for (int i = 0; i < 3; i++) {
        FILE *file = fopen(files[i], "w");
        fputs("{}", file);
        fclose(file);
    }
}

TestSuite(extra_files, .init = lab_enter, .fini = folder_leave);

static char *extra_notes(void)
{
    const Manifest manifest = manifest_02();
    char *notes = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&notes, &n_bytes);
    stands_out_in_folder(&manifest, "own", file);
    fclose(file);
    return notes;
}

static void put(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    cr_assert_not_null(file);
    fputs(text, file);
    fclose(file);
}

Test(extra_files, what_came_with_the_lab_is_none)
{
    put("own/README.md", "changed");
    put("own/lab.json", "{}");
    char *notes = extra_notes();
    cr_expect_str_eq(notes, "");
    free(notes);
}

Test(extra_files, a_manifest_of_ones_own_is_one)
{
    put("own/lab.json", "{\"points\": 100}");
    char *notes = extra_notes();
    cr_expect_str_eq(notes, "handed in besides, and not looked at: \"lab.json\"\n");
    free(notes);
}

Test(extra_files, in_order_and_without_control_characters)
{
    put("own/b\n1: forged", "");
    put("own/a\033[2J", "");
    cr_assert_eq(symlink("/", "own/c"), 0);
    char *notes = extra_notes();
    cr_expect_str_eq(
        notes, "handed in besides, and not looked at: \"a\\x1B[2J\", \"b 1: forged\", \"c\"\n");
    free(notes);
}

Test(extra_files, few_of_many_are_named)
{
    char path[64];
    for (int i = 0; i < 3000; i++) {
        snprintf(path, sizeof path, "own/%d", i);
        put(path, "");
    }
    char *notes = extra_notes();
    cr_expect_not_null(strstr(notes, "and at least 1994 more"), "%s", notes);
    free(notes);
}

Test(extra_files, no_folder_no_note)
{
    const Manifest manifest = manifest_02();
    cr_expect_eq(stands_out_in_folder(&manifest, "nowhere", stdout), 0);
    cr_expect_eq(stands_out_in_folder(&manifest, "own/kdtree2d_build.c", stdout), 0);
}
