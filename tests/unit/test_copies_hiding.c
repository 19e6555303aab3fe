// copies/forms: a text has its forms whatever is put around it to hide it.
#include "expression.h"
#include "form_list.h"
#include "forms.h"
#include "hard.h"
#include "message.h"
#include "scope.h"
#include "surroundings.h"
#include "trial.h"

#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

static const char text[] = "x = nodes[id].lChild; if (dot(x, y) < nodes[id].minX) { steps = x; }";

static int has_form(const Forms *forms, const Form *form)
{
    for (int i = 0; i < forms->n; i++) {
        if (forms->all[i].kind == form->kind && strcmp(forms->all[i].text, form->text) == 0) {
            return 1;
        }
    }
    return 0;
}

// Has a text that was changed by its author all statements of the plain one? Its forms: release
// them.
static Forms statements_are_in(const char *plain, const char *changed, const NameSet *given)
{
    Forms expected = forms_read(plain, given), found = forms_read(changed, given);
    cr_expect_gt(expected.n, 0);
    for (int i = 0; i < expected.n; i++) {
        cr_expect(expected.all[i].kind != FORM_STATEMENT || has_form(&found, &expected.all[i]),
                  "%s is not in: %.300s", expected.all[i].text, changed);
    }
    forms_free(&expected);
    return found;
}

static int count_statements(const Forms *forms)
{
    int n = 0;
    for (int i = 0; i < forms->n; i++) {
        n += forms->all[i].kind == FORM_STATEMENT;
    }
    return n;
}

// `n` different texts that a format makes.
__attribute__((format(printf, 1, 0))) static char *numbered(const char *format, int n)
{
    char *all = NULL;
    size_t n_bytes;
    FILE *stream = open_memstream(&all, &n_bytes);
    for (int i = 0; i < n; i++) {
        fprintf(stream, format, i);
    }
    fclose(stream);
    return all;
}

static char *repeated(const char *piece, int n)
{
    char *all = calloc((size_t)n + 1, strlen(piece));
    char *end = all;
    for (int i = 0; i < n; i++) {
        end = stpcpy(end, piece);
    }
    return all;
}

Test(copies_hiding, what_no_compiler_reads_has_no_forms)
{
    static const char *const rows[] = {
        "#if 0\njunk(1); // of many words\n#endif\n%s",
        "#if 0u // why\n#if 1\njunk(1);\n#else\njunk(2);\n#endif\n#elif "
        "0x0\njunk();\n#else\n%s\n#endif\n",
        "#if 1\n%s\n#else\njunk(1);\n#endif\n",
        "#if 2\n%s\n#elif HAS_JUNK\njunk(1);\n#endif\n",
        "%:if 0 \\\n\njunk(1);\n?\?=endif\n%s",
        "%s\n#if false\njunk(1);",
        "if (0) { junk(1); { junk(2); } }\n%s",
        "do {\n%s\n} while (0);",
        "#if 0\n#define P junk();\n#include \"junk\"\n#endif\n%s",
    };
    Forms plain = forms_read(text, NULL);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const char *at = strstr(rows[i], "%s");
        char *changed = message_new("%.*s%s%s", (int)(at - rows[i]), rows[i], text, at + 2);
        Forms found = statements_are_in(text, changed, NULL);
        const int n_loops = strstr(rows[i], "while") != NULL;
        cr_expect_eq(count_statements(&found), count_statements(&plain) + n_loops, "%s", changed);
        cr_expect_eq(found.n_left_out > 0, strstr(rows[i], "junk(1)") != NULL, "%s", changed);
        cr_expect_eq(found.n_with_directive, 0);
        cr_expect_eq(found.is_cut, 0);
        forms_free(&found);
        free(changed);
    }
    forms_free(&plain);
}

Test(copies_hiding, lines_keep_their_numbers)
{
    Forms forms = forms_read("#if 0\na;\n/* b\n c */ d;\n#endif\nx = 1;\n", NULL);
    cr_assert_eq(forms.n, 1);
    cr_expect_eq(forms.all[0].first_line, 6);
    forms_free(&forms);
}

Test(copies_hiding, what_may_run_has_its_forms)
{
    static const char *const rows[] = {
        "#define P0 x = nodes[id].lChild;\nP0 if (dot(x, y) < nodes[id].minX) { steps = x; }",
        "#define P0 x = nodes[id].lChild; \\\n if (dot(x, y) < nodes[id].minX) { steps = x; }\nP0",
        "#define P0(a, b) if (dot(a, b) < nodes[id].minX) { \\\n steps = x; }\n"
        "x = nodes[id].lChild; P0(x, y)\nif (dot(x, y) < nodes[id].minX)",
        "#ifdef NEVER\n#else\nx = nodes[id].lChild; if (dot(x, y) < nodes[id].minX) {\n"
        "#endif\nsteps = x; }",
        "goto in; if (0) { in: x = nodes[id].lChild; if (dot(x, y) < nodes[id].minX) "
        "{ steps = x; } }",
        "if (0) for (; f();) {} x = nodes[id].lChild; if (dot(x, y) < nodes[id].minX) steps = x;",
        "void p(void) { x = nodes[id].lChild; if (dot(x, y) < nodes[id].minX) { steps = x; } } "
        "p();",
        "#define DO(what) what\nDO(x = nodes[id].lChild;) if (dot(x, y) < nodes[id].minX) { "
        "DO(steps = x) }",
        "({ x = nodes[id].lChild; }); if (dot(x, y) < nodes[id].minX) ({ steps = x; });",
        "a: x = nodes[id].lChild; b: if (dot(x, y) < nodes[id].minX) { c: steps = x; }",
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Forms found = statements_are_in(text, rows[i], NULL);
        cr_expect_eq(found.n_with_directive > 0, strncmp(rows[i], "#define P", 9) == 0 ||
                                                     strncmp(rows[i], "#define DO", 10) == 0);
        cr_expect_eq(found.n_conditional > 0, strncmp(rows[i], "#ifdef", 6) == 0);
        forms_free(&found);
    }
    // A macro is as good as a constant, and its name is the answer's own.
    Forms found = statements_are_in("const float eps = 1e-4f; f(eps);",
                                    "#define EPSILON 0.0001f\nf(EPSILON);", NULL);
    cr_expect_eq(found.n_with_directive, 0);
    forms_free(&found);
}

Test(copies_hiding, a_functions_body_is_read)
{
    Forms body =
        statements_are_in("float a; float sum = a; return sum; half(y);",
                          "float twice(float b) { float c = b; return c; } half(y);", NULL);
    forms_free(&body);
    Forms found = statements_are_in("float one(float a) { return a; } x = one(y);",
                                    "float other(float z) { return z; } x = other(y);", NULL);
    forms_free(&found);
}

Test(copies_hiding, what_the_lab_declares_is_never_ones_own)
{
    NameSet given = scope_names("float helper(int h)\n{\n    int out = 0;\n}\n"
                                "kernel void f(int id, global Node *nodes)\n{\n"
                                "    for (int i = 0; i < id; i++) {\n        int gone;\n    }\n"
                                "    int steps = nodes[id].member;\n"
                                "    // TASK one: do it\n    return;\n    // END one\n"
                                "    int later;\n}\n",
                                "one");
    static const char *const in[] = {"id", "nodes", "steps", "helper", "f"};
    static const char *const out[] = {"i", "gone", "later", "h", "out", "member", "return"};
    for (size_t i = 0; i < sizeof in / sizeof *in; i++) {
        cr_expect(name_set_has(&given, in[i]), "%s", in[i]);
    }
    for (size_t i = 0; i < sizeof out / sizeof *out; i++) {
        cr_expect(!name_set_has(&given, out[i]), "%s", out[i]);
    }
    static const char *const shadows[] = {
        "{ int id = 0, nodes = 0, steps = 0, dot = 0; (void)id; }",
        "{ float dot(float); float id(void); }",
        "#define id id\n#define dot (dot)\n",
    };
    for (size_t i = 0; i < sizeof shadows / sizeof *shadows; i++) {
        char *changed = message_new("%s %s", shadows[i], text);
        Forms found = statements_are_in(text, changed, &given);
        forms_free(&found);
        free(changed);
    }
    name_set_free(&given);
    given = scope_names("int x;\n", "one");
    cr_expect_eq(given.n, 0);
    name_set_free(&given);
}

Test(copies_hiding, much_before_a_text_leaves_it_its_forms)
{
    char *same = repeated("z;", 60000);
    char *names = numbered("int n%d;", 5000);
    char *deep = repeated("if (0) { a: ; ", 8000);
    const char *const rows[] = {same, names};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char *changed = message_new("%s float own = y; f(own);", rows[i]);
        Forms found = statements_are_in("float other = y; f(other);", changed, NULL);
        cr_expect_eq(found.is_cut, 0);
        forms_free(&found);
        free(changed);
    }
    Forms found = forms_read(deep, NULL);  // does not take long
    cr_expect_eq(found.is_cut, 1);
    forms_free(&found);
    free(same), free(names), free(deep);
}

Test(copies_hiding, limits_are_told)
{
    char *different = numbered("f(%d);", FORMS_MAX + 1);
    char *names = numbered("#define n%d\n", OWN_NAMES_MAX + 1);
    char *sum = numbered("+ a%d", 600);
    char *long_names = numbered("+ aVeryLongNameOfAVariableThatIsInTheSum%d", 150);
    char *rows[] = {different, names, sum, long_names};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Forms found = forms_read(rows[i], NULL);
        cr_expect_eq(found.is_cut, 1, "%.20s", rows[i]);
        cr_expect_leq(found.n, FORMS_MAX + 1);
        for (int f = 0; f < found.n; f++) {
            cr_expect_leq(strlen(found.all[f].text), 2 * strlen(rows[i]));
        }
        forms_free(&found);
        free(rows[i]);
    }
}

// No memory is left: the message names what was read, so that an instructor can do without it.
static void read_and_forget(void *answer)
{
    Forms forms = forms_read(answer, NULL);
    forms_free(&forms);
}

// As much as fits into a file that is handed in, of what has no end or no sense.
Test(copies_hiding, no_text_takes_long)
{
    static const struct {
        const char *first, *then;
    } rows[] = {
        {"auto ", "{"},   {"x (", "{"},           {"x ", "{}"},      {"f(a) ", "{} "},
        {"", "if (0) {"}, {"", "case "},          {"f(", "int a, "}, {"", "(int "},
        {"x", "(- "},     {"x ", "/*a*\\\n/ b "}, {"", "#if A\n"},   {"", "#define A(x) x;\n"},
    };
    enum { MOST_BYTES = 256 * 1024, FIRST_BYTES = 100000 };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const size_t n_first = rows[i].first[0] != '\0' ? strlen(rows[i].first) : 1;
        const int n_times = i == 0 ? (int)(FIRST_BYTES / n_first) : 1;
        char *first = repeated(rows[i].first, n_times);
        char *then =
            repeated(rows[i].then, (int)((MOST_BYTES - strlen(first)) / strlen(rows[i].then)));
        char *answer = message_new("%s%s", first, then);
        cr_expect(trial_ends(read_and_forget, answer), "\"%s\" and \"%s\"", rows[i].first,
                  rows[i].then);
        free(first), free(then), free(answer);
    }
}

static void never_end(void *unused)
{
    volatile int is_done = 0;
    (void)unused;
    while (!is_done) {
    }
}

static void take_all_memory(void *unused)
{
    (void)unused;
    for (;;) {
        memset(memory_take(1 << 20), 1, 1 << 20);
    }
}

Test(copies_hiding, a_trial_that_takes_too_much_is_ended)
{
    const struct rlimit second = {1, 1};  // in place of ten
    cr_assert_eq(setrlimit(RLIMIT_CPU, &second), 0);
    cr_expect_not(trial_ends(never_end, NULL));
#ifndef __SANITIZE_ADDRESS__  // it has no limit of memory then
    cr_expect_not(trial_ends(take_all_memory, NULL));
#else
    (void)take_all_memory;
#endif
}

Test(copies_hiding, whose_trial_was_ended_is_hard_to_compare)
{
    Author authors[2] = {{.is_given_up = 1}, {0}};
    const Alike alike = {.class = {.authors = authors, .n_authors = 2}};
    char *reason = hard_reason(&alike, &authors[0]);
    cr_assert_not_null(reason);
    cr_expect_not_null(strstr(reason, "nothing is compared"), "%s", reason);
    cr_expect_eq(hard_count(&alike), 1);
    free(reason);
}

Test(copies_hiding, short_memory_ends_the_program, .exit_code = 2)
{
    memory_reading("ada-lovelace");
    memory_end();
}
