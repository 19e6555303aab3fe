// Reading the forms of an answer, statement by statement (see forms.h).
#include "forms.h"

#include "form_list.h"
#include "forms_parts.h"
#include "message.h"

#include <stdlib.h>
#include <string.h>

// Blocks that never run may be in each other: looking for their ends reads a text so often at most.
enum { MOST_LOOKS = 20 };

typedef struct Splitter {
    const SourceWord *words;
    int n;                  // of the piece that is read: the text, or one macro's
    const NameSet *macros;  // that can stand where a statement does
    OwnNames own;
    Forms forms;
    int n_looked_at;  // words, in search of what never runs
    int reads_names;  // the first pass: only what is declared is noted
} Splitter;

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
    char *form =
        expression_form(splitter->words, from, to, &splitter->own, &splitter->forms.is_cut);
    char *text = message_new("%s%s%s", keyword, keyword[0] != '\0' ? " " : "", form);
    free(form);
    forms_add(&splitter->forms, FORM_STATEMENT, text, splitter->words[from].line,
              splitter->words[to - 1].line);
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
        own_names_add(&splitter->own, &splitter->words[from], 0);
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

// ---- Functions and blocks --------------------------------------------------------------------

// Does what begins at `from` make the "{" at `open` a function's, a structure's, or that of a macro
// (EACH(i) { ... })?
static int is_block(const Splitter *splitter, int from, int open)
{
    const int is_call = splitter->words[from].kind == SOURCE_NAME &&
                        !is_name(splitter, from, "return") && is_sign(splitter, from + 1, "(") &&
                        find_sign(splitter, from + 2, open, ")") + 1 == open;
    return is_call || declarators_find(splitter, from, open) >= 0;
}

// The end of a statement that begins at `from`: its ;, or the "{" of a block, or what cannot be in
// it and follows a macro: a keyword, the end of a bracket around it. Only the first "{" that no
// bracket holds can be a block's: what is_block() reads is before it.
static int statement_end(const Splitter *splitter, int from)
{
    int depth = 0, has_value = 0, n_opened = 0;
    for (int at = from; at < splitter->n; at++) {
        const SourceWord *word = &splitter->words[at];
        const int is_a_sign = word->kind == SOURCE_SIGN;
        const int closes = is_a_sign && source_is_one_of(word, ") ] }");
        const int opens = is_a_sign && source_is_one_of(word, "( [ {");
        const int is_first =
            is_a_sign && word->text[0] == '{' && depth == 0 && !has_value && n_opened++ == 0;
        const int ends =
            is_a_sign ? closes || word->text[0] == ';' || (is_first && is_block(splitter, from, at))
                      : word->kind == SOURCE_NAME &&
                            source_is_one_of(word, "if while for switch do return");
        if (depth == 0 && at > from && ends) {
            return at;
        }
        has_value |= is_a_sign && source_is_one_of(word, "=");
        depth += opens - (closes && depth > 0);
    }
    return splitter->n;
}

// What is before a block's "{" at `open`: of a function the name and the parameters.
static void head_add(Splitter *splitter, int from, int open)
{
    const int bracket = find_sign(splitter, from, open, "(");
    const int close = find_sign(splitter, bracket + 1, open, ")");
    if (declarators_find(splitter, from, open) < 0) {
        expression_add(splitter, "", from, open);
        return;
    }
    if (bracket < open && splitter->reads_names) {
        own_names_add(&splitter->own, &splitter->words[bracket - 1], 1);
    }
    for (int at = bracket + 1; at < close;) {
        const int end = find_sign(splitter, at, close, ",");
        simple_add(splitter, at, end);
        at = end + 1;
    }
}

// `if (0) { ... }` never runs, if nothing jumps into it. Returns its end, or `at` if this is none.
static int never_find(Splitter *splitter, int at)
{
    const int is_never = (is_name(splitter, at, "if") || is_name(splitter, at, "while")) &&
                         is_sign(splitter, at + 1, "(") && at + 2 < splitter->n &&
                         source_is_one_of(&splitter->words[at + 2], "0 false 0u 0U") &&
                         is_sign(splitter, at + 3, ")") && is_sign(splitter, at + 4, "{");
    if (!is_never) {
        return at;
    }
    if (splitter->n_looked_at > MOST_LOOKS * splitter->n) {
        splitter->forms.is_cut = 1;
        return at;
    }
    const int end = find_sign(splitter, at + 5, splitter->n, "}");
    splitter->n_looked_at += end - at;
    for (int i = at + 5; i < end; i++) {
        if (is_sign(splitter, i, ":")) {
            return at;  // a label may be in it, or a case
        }
    }
    return end;
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

// A statement without a keyword for its condition. Returns where the next one begins.
static int statement_add(Splitter *splitter, int at)
{
    const int end = statement_end(splitter, at);
    if (is_name(splitter, at, "return")) {
        expression_add(splitter, "return", at + 1, end);
    } else if (is_sign(splitter, end, "{")) {
        head_add(splitter, at, end);
    } else {
        simple_add(splitter, at, end);
    }
    return end + (is_sign(splitter, end, ";") || is_sign(splitter, end, "{"));
}

static void statements_read(Splitter *splitter)
{
    int at = 0;
    while (at < splitter->n) {
        const SourceWord *word = &splitter->words[at];
        const int never = never_find(splitter, at);
        if (never > at) {
            splitter->forms.n_left_out += splitter->reads_names ? 0 : never - at;
            at = never;
        } else if (word->kind == SOURCE_SIGN && source_is_one_of(word, "{ } ; )")) {
            at++;
        } else if (is_sign(splitter, at, "(") && is_sign(splitter, at + 1, "{")) {
            at += 2;  // gcc's ({ ... })
        } else if (word->kind == SOURCE_NAME && source_is_one_of(word, "else do default")) {
            at += 1 + is_sign(splitter, at + 1, ":");
        } else if (word->kind == SOURCE_NAME && source_is_one_of(word, "if while for switch") &&
                   is_sign(splitter, at + 1, "(")) {
            at = control_add(splitter, at);
        } else if (is_name(splitter, at, "case")) {
            const int end = find_sign(splitter, at, splitter->n, ":");
            expression_add(splitter, "case", at + 1, end);
            at = end + 1;
        } else if (word->kind == SOURCE_NAME && is_sign(splitter, at + 1, ":")) {
            at += 2;  // a label
        } else if (word->kind == SOURCE_NAME && name_set_has(splitter->macros, word->text)) {
            at += 1 + is_sign(splitter, at + 1, "(");  // its arguments may be statements
        } else {
            at = statement_add(splitter, at);
        }
    }
}

// Read the text, then what each macro stands for.
static void pieces_read(Splitter *splitter, const SourceWord *words, int n_words,
                        const Macros *macros)
{
    splitter->words = words;
    splitter->n = n_words;
    splitter->n_looked_at = 0;
    splitter->macros = &macros->in_place;
    statements_read(splitter);
    for (int from = 0; from < macros->n_words; from += splitter->n + 1) {
        splitter->words = macros->words + from;
        splitter->n = 0;
        while (splitter->words[splitter->n].kind != SOURCE_END) {
            splitter->n++;
        }
        statements_read(splitter);
    }
}

Forms forms_read(const char *answer, const NameSet *given)
{
    Splitter splitter = {.own.given = given};
    Forms *forms = &splitter.forms;
    LiveCount count = {0};
    char *live = live_text(answer, &count);
    SourceWord *words = source_words(live, &forms->n_words);
    if (words == NULL) {
        memory_end();
    }
    Macros macros = macros_read(live, &splitter.own);
    forms->n_left_out = count.n_left_out;
    forms->n_conditional = count.n_conditional;
    forms->n_with_directive = macros.n_statements;
    for (splitter.reads_names = 1; splitter.reads_names >= 0; splitter.reads_names--) {
        pieces_read(&splitter, words, forms->n_words, &macros);
    }
    remarks_read(live, &splitter.own, forms);
    forms->is_cut |= splitter.own.is_full;
    forms_complete(forms);
    own_names_free(&splitter.own);
    macros_free(&macros);
    free(words);
    free(live);
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
