// Reading the forms of an answer, statement by statement (see forms.h).
#include "forms.h"

#include "complain.h"
#include "expression.h"
#include "form_list.h"
#include "message.h"
#include "remarks.h"

#include <stdlib.h>
#include <string.h>

typedef struct Splitter {
    const SourceWord *words;
    int n;
    OwnNames own;
    Forms forms;
    int reads_names;  // the first pass: only what is declared is noted
} Splitter;

void forms_add(Forms *forms, FormKind kind, char *text, int first_line, int last_line)
{
    if (forms->n >= FORMS_MAX || text[0] == '\0') {
        free(text);
        return;
    }
    forms->all = array_grow(forms->all, forms->n, sizeof *forms->all);
    forms->all[forms->n++] = (Form){kind, text, first_line, last_line, -1};
}

static int is_sign(const Splitter *splitter, int at, const char *sign)
{
    return at < splitter->n && source_is(&splitter->words[at], SOURCE_SIGN, sign);
}

static int is_name(const Splitter *splitter, int at, const char *name)
{
    return at < splitter->n && source_is(&splitter->words[at], SOURCE_NAME, name);
}

// The first `sign` from `at` on that no bracket holds, or `end`.
static int find_sign(const Splitter *splitter, int at, int end, const char *sign)
{
    int depth = 0;
    for (; at < end; at++) {
        const SourceWord *word = &splitter->words[at];
        if (depth == 0 && source_is(word, SOURCE_SIGN, sign)) {
            return at;
        }
        if (word->kind == SOURCE_SIGN && word->length == 1) {
            depth += strchr("([{", word->text[0]) != NULL;
            depth -= depth > 0 && strchr(")]}", word->text[0]) != NULL;
        }
    }
    return end;
}

// ---- One statement ---------------------------------------------------------------------------

// Add the form "keyword expression" of words from..to.
static void expression_add(Splitter *splitter, const char *keyword, int from, int to)
{
    if (splitter->reads_names || from >= to) {
        return;
    }
    char *form = expression_form(splitter->words, from, to, &splitter->own);
    char *text = message_new("%s%s%s", keyword, keyword[0] != '\0' ? " " : "", form);
    free(form);
    forms_add(&splitter->forms, FORM_STATEMENT, text, splitter->words[from].line,
              splitter->words[to - 1].line);
}

static void own_name_add(Splitter *splitter, const SourceWord *name)
{
    OwnNames *own = &splitter->own;
    if (own_names_have(own, name) || own->n >= EXPRESSION_MAX_WORDS) {
        return;
    }
    own->names = array_grow(own->names, own->n, sizeof *own->names);
    own->names[own->n++] = message_new("%s", name->text);
}

// `* name [size] = value` of a declaration. What is declared and not set has no form of its own.
static void declarator_add(Splitter *splitter, int from, int to)
{
    while (from < to && (is_sign(splitter, from, "*") || is_qualifier(&splitter->words[from]))) {
        from++;
    }
    if (from >= to || splitter->words[from].kind != SOURCE_NAME) {
        expression_add(splitter, "", from, to);
        return;
    }
    if (splitter->reads_names) {
        own_name_add(splitter, &splitter->words[from]);
    } else {
        forms_add(&splitter->forms, FORM_NAME, message_new("%s", splitter->words[from].text),
                  splitter->words[from].line, splitter->words[from].line);
        if (find_sign(splitter, from, to, "=") < to) {
            expression_add(splitter, "", from, to);
        }
    }
}

// Where the declarators of a declaration begin, or -1 where it is none.
static int declarators_find(const Splitter *splitter, int from, int to)
{
    int at = from, n_types = 0;
    while (at < to && (is_qualifier(&splitter->words[at]) ||
                       (n_types < 3 && is_type_name(&splitter->words[at])))) {
        n_types += is_type_name(&splitter->words[at]);
        at++;
    }
    // A type of another form, by its place: `real_t x`.
    if (n_types == 0 && at + 1 < to && splitter->words[at].kind == SOURCE_NAME &&
        splitter->words[at + 1].kind == SOURCE_NAME) {
        return at + 1;
    }
    const int has_name = at < to && (splitter->words[at].kind == SOURCE_NAME ||
                                     (is_sign(splitter, at, "*") && n_types > 0));
    return n_types > 0 && has_name ? at : -1;
}

static void simple_add(Splitter *splitter, int from, int to)
{
    int at = declarators_find(splitter, from, to);
    if (at < 0) {
        expression_add(splitter, "", from, to);
        return;
    }
    while (at < to) {
        const int end = find_sign(splitter, at, to, ",");
        declarator_add(splitter, at, end);
        at = end + 1;
    }
}

// ---- All statements --------------------------------------------------------------------------

// `for (first; condition; step)`: its brackets are at `open` and `close`.
static void for_add(Splitter *splitter, int open, int close)
{
    const int first = find_sign(splitter, open + 1, close, ";");
    const int second = find_sign(splitter, first + 1, close, ";");
    simple_add(splitter, open + 1, first);
    expression_add(splitter, "loop", first + 1, second);
    expression_add(splitter, "", second + 1, close);
}

// A keyword with a condition in brackets. Returns where what follows begins.
static int control_add(Splitter *splitter, int at)
{
    const int is_for = is_name(splitter, at, "for");
    const char *keyword = is_name(splitter, at, "while") ? "loop" : splitter->words[at].text;
    const int open = at + 1;
    const int close = find_sign(splitter, open + 1, splitter->n, ")");
    if (is_for) {
        for_add(splitter, open, close);
    } else {
        expression_add(splitter, keyword, open + 1, close);
    }
    return close + 1;
}

static void statements_read(Splitter *splitter)
{
    int at = 0;
    while (at < splitter->n) {
        const SourceWord *word = &splitter->words[at];
        if (word->kind == SOURCE_SIGN && source_is_one_of(word, "{ } ;")) {
            at++;
        } else if (word->kind == SOURCE_NAME && source_is_one_of(word, "else do default")) {
            at += 1 + is_sign(splitter, at + 1, ":");
        } else if (word->kind == SOURCE_NAME && source_is_one_of(word, "if while for switch") &&
                   is_sign(splitter, at + 1, "(")) {
            at = control_add(splitter, at);
        } else if (is_name(splitter, at, "case")) {
            const int end = find_sign(splitter, at, splitter->n, ":");
            expression_add(splitter, "case", at + 1, end);
            at = end + 1;
        } else {
            const int end = find_sign(splitter, at, splitter->n, ";");
            if (is_name(splitter, at, "return")) {
                expression_add(splitter, "return", at + 1, end);
            } else {
                simple_add(splitter, at, end);
            }
            at = end + 1;
        }
    }
}

Forms forms_read(const char *answer)
{
    Splitter splitter = {0};
    SourceWord *words = source_words(answer, &splitter.n);
    if (words == NULL) {
        complain("copies: out of memory");
        exit(2);
    }
    splitter.words = words;
    for (splitter.reads_names = 1; splitter.reads_names >= 0; splitter.reads_names--) {
        statements_read(&splitter);
    }
    remarks_read(answer, &splitter.own, &splitter.forms);
    for (int i = 0; i < splitter.own.n; i++) {
        free(splitter.own.names[i]);
    }
    free(splitter.own.names);
    free(words);
    return splitter.forms;
}

void forms_free(Forms *forms)
{
    for (int i = 0; i < forms->n; i++) {
        free(forms->all[i].text);
    }
    free(forms->all);
    *forms = (Forms){0};
}
