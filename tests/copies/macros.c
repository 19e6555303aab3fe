// Reading #define (see forms_parts.h).
#include "forms_parts.h"

#include "form_list.h"

#include <stdlib.h>

// The words of one directive, without its #.
typedef struct Line {
    SourceWord *words;
    int n;
} Line;

static void word_add(Macros *macros, SourceWord word)
{
    macros->words = array_grow(macros->words, macros->n_words, sizeof *macros->words);
    macros->words[macros->n_words++] = word;
}

static void words_add(Macros *macros, const Line *line, int from)
{
    for (int i = from; i < line->n; i++) {
        word_add(macros, line->words[i]);
    }
    word_add(macros, (SourceWord){.kind = SOURCE_END});
}

static int line_has(const Line *line, int from, const char *signs)
{
    for (int i = from; i < line->n; i++) {
        if (line->words[i].kind == SOURCE_SIGN && source_is_one_of(&line->words[i], signs)) {
            return 1;
        }
    }
    return 0;
}

static int line_names(const Line *line, int from, const SourceWord *name)
{
    for (int i = from; i < line->n; i++) {
        if (source_is(&line->words[i], SOURCE_NAME, name->text)) {
            return 1;
        }
    }
    return 0;
}

// The parameters of a macro, from behind "(" on. Returns where its body begins.
static int parameters_read(const Line *line, int at, OwnNames *own)
{
    for (; at < line->n && !source_is(&line->words[at], SOURCE_SIGN, ")"); at++) {
        if (line->words[at].kind == SOURCE_NAME) {
            own_names_add(own, &line->words[at], 1);
        }
    }
    return at + 1;
}

// `define NAME body` or `define NAME(parameters) body`.
static void define_read(Macros *macros, const Line *line, OwnNames *own)
{
    const SourceWord *name = &line->words[1];
    const int takes_some = line->n > 2 && source_is(&line->words[2], SOURCE_SIGN, "(") &&
                           line->words[2].start == name->start + name->length;
    const int from = takes_some ? parameters_read(line, 3, own) : 2;
    if (!line_names(line, from, name)) {
        own_names_add(own, name, 1);
    }
    const int has_statements = line_has(line, from, "; { } = += -= *= /= ++ --");
    const int is_other_name = from + 1 == line->n && line->words[from].kind == SOURCE_NAME;
    macros->n_statements += has_statements || is_other_name;
    if (has_statements || takes_some) {
        name_set_add(&macros->in_place, name->text);
    }
    if (!has_statements && !takes_some && from < line->n) {
        word_add(macros, *name);
        word_add(
            macros,
            (SourceWord){
                .kind = SOURCE_SIGN, .text = "=", .start = "=", .length = 1, .line = name->line});
        words_add(macros, line, from);
    }
    // A call, say, may stand for a statement. A number or a name does not.
    if (has_statements || from + 1 < line->n) {
        words_add(macros, line, from);
    }
}

static void line_read(Macros *macros, const Line *line, OwnNames *own)
{
    if (line->n > 1 && source_is(&line->words[0], SOURCE_NAME, "define") &&
        line->words[1].kind == SOURCE_NAME) {
        define_read(macros, line, own);
    } else if (line->n > 0 && source_is(&line->words[0], SOURCE_NAME, "include")) {
        macros->n_statements++;
    }
}

Macros macros_read(const char *live, OwnNames *own)
{
    Macros macros = {0};
    Line line = {0};
    SourceReader reader = source_reader(live);
    for (;;) {
        const SourceWord word = source_next(&reader);
        if (!word.in_directive || word.begins_directive || word.kind == SOURCE_END) {
            line_read(&macros, &line, own);
            line.n = 0;
        } else {
            line.words = array_grow(line.words, line.n, sizeof *line.words);
            line.words[line.n++] = word;
        }
        if (word.kind == SOURCE_END) {
            break;
        }
    }
    free(line.words);
    return macros;
}

void macros_free(Macros *macros)
{
    free(macros->words);
    name_set_free(&macros->in_place);
    *macros = (Macros){0};
}
