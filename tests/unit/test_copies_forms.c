// copies/forms: what does not change a statement's form, and what does.
#include "forms.h"
#include "message.h"
#include "surroundings.h"

#include <stdlib.h>
#include <string.h>

static int text_compare(const void *left, const void *right)
{
    const Form *a = left, *b = right;
    return strcmp(a->text, b->text);
}

// All forms of a kind, sorted, one a line; free() it.
static char *forms_text(const char *answer, FormKind kind)
{
    Forms forms = forms_read(answer, NULL);
    char *text = NULL;
    size_t n_bytes;
    FILE *stream = open_memstream(&text, &n_bytes);
    qsort(forms.all, (size_t)forms.n, sizeof *forms.all, text_compare);
    for (int i = 0; i < forms.n; i++) {
        if (forms.all[i].kind == kind) {
            fprintf(stream, "%s\n", forms.all[i].text);
        }
    }
    fclose(stream);
    forms_free(&forms);
    return text;
}

typedef struct Both {
    const char *one, *other;
} Both;

static void expect_forms(const Both *rows, size_t n, int are_same)
{
    for (size_t i = 0; i < n; i++) {
        char *one = forms_text(rows[i].one, FORM_STATEMENT);
        char *other = forms_text(rows[i].other, FORM_STATEMENT);
        cr_expect_eq(strcmp(one, other) == 0, are_same, "%s | %s", rows[i].one, rows[i].other);
        cr_expect_neq(one[0], '\0', "%s", rows[i].one);
        free(one), free(other);
    }
}

Test(copies_forms, are_the_same)
{
    static const Both rows[] = {
        {"float a = x; y(a);", "y(zz); const float zz = x;"},
        {"int i = 0; while (i < n) { f(i); i += 1; }", "for (uint k = 0; k < n; ++k) f(k);"},
        {"float a; a = 1.0f;", "float b = 1.f;"},
        {"if (a > b && c) return 1;", "if (c && b < a) { return (1); }"},
        {"x = (a + b) * c - 2.0f;", "x = c * (b + a) + (-2.0f);"},
        {"s += a * b;", "s = s + b * a;"},
        {"return a == b ? c : d;", "return (b == a) ? c : d;"},
        {"t = (float3)(1.0f, 0, y);", "t = (float3)(1, 0.0f, y) ;"},
        {"global const uint *p = q; u(*p);", "u(*list); global const uint *list = q;"},
        {"float a = 1, b = 2;", "float b = 2; float a = 1;"},
        {"do { f(); } while (x != 0);", "while (0 != x) f();"},
        {"i--;", "i = i - 1;"},
        {"x\t=\ty ; // why\r\n", "x=y;"},
        {"return (float2){a, 1};", "return (float2){a, 1.f};"},
    };
    expect_forms(rows, sizeof rows / sizeof *rows, 1);
}

Test(copies_forms, are_different)
{
    static const Both rows[] = {
        {"x = a - b;", "x = b - a;"},
        {"x = a / b;", "x = b / a;"},
        {"if (a < b) return 1;", "if (a <= b) return 1;"},
        {"if (a < b) return 1;", "if (b < a) return 1;"},
        {"f(a, b);", "f(b, a);"},
        {"x.r = c.r;", "x.g = c.g;"},
        {"return a ? b : c;", "return a ? c : b;"},
        {"while (a) f();", "if (a) f();"},
        {"x = 1;", "x = 2;"},
        {"x = a[b];", "x = b[a];"},
        {"x = a * b + c;", "x = a * (b + c);"},
        {"x = a ^ b;", "x = a | b;"},
        {"width = 1;", "height = 1;"},
        {"return (float2){a, 1};", "return (float2){a, 2};"},
    };
    expect_forms(rows, sizeof rows / sizeof *rows, 0);
}

Test(copies_forms, of_comments_and_names)
{
    static const char answer[] = "// The nearest  ONE wins!\n"
                                 "uint next = 0; /* two\n words and */ const char *s = \"// no\";\n"
                                 "x = 1; // too short\n";
    char *comments = forms_text(answer, FORM_COMMENT);
    char *names = forms_text(answer, FORM_NAME);
    cr_expect_str_eq(comments, "the nearest one wins\ntwo words and\n");
    cr_expect_str_eq(names, "next\ns\n");
    free(comments), free(names);
}

Test(copies_forms, of_odd_blanks)
{
    char *none = forms_text("  if (x) {\n      f(a, b);  // at the side\n\n    }\r\n", FORM_BLANKS);
    char *some = forms_text("float a =  1; \nf(a ,b) ;\n\tg();\t\r\n", FORM_BLANKS);
    cr_expect_str_eq(none, "");
    cr_expect_str_eq(some, "0 blanks, 1 tabs, after ; before the line's end\n"
                           "1 blanks, 0 tabs, after ) before ;\n"
                           "1 blanks, 0 tabs, after ; before the line's end\n"
                           "1 blanks, 0 tabs, after _ before ,\n"
                           "2 blanks, 0 tabs, after = before 1\n");
    free(none), free(some);
}

Test(copies_forms, stand_at_their_lines)
{
    Forms forms = forms_read("\n  x = 1;\n  f(a,\n    b);\n  // one two three\n", NULL);
    cr_assert_eq(forms.n, 3);
    cr_expect_eq(forms.all[0].first_line, 2);
    cr_expect_eq(forms.all[1].first_line, 3);
    cr_expect_eq(forms.all[1].last_line, 4);
    cr_expect_eq(forms.all[2].kind, FORM_COMMENT);
    cr_expect_eq(forms.all[2].first_line, 5);
    forms_free(&forms);
}

// `n` times a text.
static char *repeated(const char *text, int n)
{
    char *all = calloc((size_t)n + 1, strlen(text));
    char *end = all;
    for (int i = 0; i < n; i++) {
        end = stpcpy(end, text);
    }
    return all;
}

// None of these takes long, reads beyond its end or recurses without one.
Test(copies_forms, of_what_is_no_program)
{
    static const char *const pieces[] = {
        "(",  "(-",   "((float)", "[",  "{",  "a?",   "if(", "for(",     "a+",
        "- ", "a.",   "case ",    ")",  "]",  "/*",   "\"",  "x=",       "f(a,",
        ";",  "int ", "!",        "++", ", ", "\\\n", "#",   "(float3)("};
    static const char *const whole[] = {
        "",   "if", "for",        "for (",      "case",    "return",          "else",
        "do", ":",  "while () ;", "for (;;) ;", "int",     "int *",           "int = 3",
        "x.", "a[", "'",          "switch (",   "return;", "default: case 1:"};
    for (size_t i = 0; i < sizeof pieces / sizeof *pieces; i++) {
        char *text = repeated(pieces[i], 30000);
        Forms forms = forms_read(text, NULL);
        cr_expect_leq(forms.n, FORMS_MAX);
        forms_free(&forms);
        free(text);
    }
    // Within the limit of words: what doubled with each sign would not fit into any memory.
    char *steps = repeated("++", 400);
    char *sums = repeated("+=1)", 100);
    char *brackets = repeated("(", 100);
    char *text = message_new("a%s; %sa%s;", steps, brackets, sums);
    Forms forms = forms_read(text, NULL);
    cr_expect_eq(forms.n, 2);
    forms_free(&forms);
    free(steps), free(sums), free(brackets), free(text);
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++) {
        Forms forms = forms_read(whole[i], NULL);
        forms_free(&forms);
    }
}
