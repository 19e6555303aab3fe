// Following the blocks of a skeleton up to a hole (see scope.h).
#include "scope.h"

#include "form_list.h"
#include "holes.h"
#include "source_words.h"

#include <stdlib.h>
#include <string.h>

// A name, and how many brackets are around it.
typedef struct Declared {
    SourceWord name;
    int depth;
} Declared;

typedef struct Blocks {
    Declared *names;
    int n;
    int n_braces, n_brackets;
} Blocks;

// The first line of a hole, or 0.
static int hole_line(const char *skeleton, const char *id)
{
    int line = 1;
    for (const char *at = skeleton; at != NULL; line++) {
        if (hole_has_line(skeleton, id, line)) {
            return line;
        }
        at = strchr(at, '\n');
        at = at != NULL ? at + 1 : NULL;
    }
    return 0;
}

static void block_end(Blocks *blocks)
{
    while (blocks->n > 0 && blocks->names[blocks->n - 1].depth > blocks->n_braces) {
        blocks->n--;
    }
}

static void sign_read(Blocks *blocks, const SourceWord *sign)
{
    blocks->n_braces += source_is_one_of(sign, "{");
    blocks->n_brackets += source_is_one_of(sign, "(");
    blocks->n_brackets -= source_is_one_of(sign, ")") && blocks->n_brackets > 0;
    if (source_is_one_of(sign, "}")) {
        blocks->n_braces -= blocks->n_braces > 0;
        block_end(blocks);
    } else if (source_is_one_of(sign, ";") && blocks->n_brackets == 0) {
        block_end(blocks);
    }
}

static void name_read(Blocks *blocks, const SourceWord *name)
{
    blocks->names = array_grow(blocks->names, blocks->n, sizeof *blocks->names);
    blocks->names[blocks->n++] = (Declared){*name, blocks->n_braces + blocks->n_brackets};
}

NameSet scope_names(const char *skeleton, const char *id)
{
    NameSet names = {0};
    Blocks blocks = {0};
    const int line = hole_line(skeleton, id);
    int n_words, is_member = 0;
    SourceWord *words = source_words(skeleton, &n_words);
    if (words == NULL) {
        memory_end();
    }
    for (int i = 0; i < n_words && words[i].line < line; i++) {
        if (words[i].kind == SOURCE_SIGN) {
            sign_read(&blocks, &words[i]);
        } else if (words[i].kind == SOURCE_NAME && !is_member) {
            name_read(&blocks, &words[i]);
        }
        is_member = words[i].kind == SOURCE_SIGN && source_is_one_of(&words[i], ". ->");
    }
    for (int i = 0; i < blocks.n; i++) {
        name_set_add(&names, blocks.names[i].name.text);
    }
    free(blocks.names);
    free(words);
    return names;
}
