// Following #if, #elif, #else and #endif (see forms_parts.h).
#include "forms_parts.h"

#include "form_list.h"
#include "source_words.h"

#include <stdlib.h>
#include <string.h>

// Deeper ones are read as if their conditions held.
enum { MOST_LEVELS = 200 };

typedef struct Level {
    int was_true;    // a branch whose condition holds has been there
    int is_unknown;  // nobody knows one of the conditions until here
    int is_dead;     // the branch that is read now is not compiled
} Level;

typedef struct Branches {
    Level levels[MOST_LEVELS];  // [0]: outside of all
    int depth;
    int n_deeper;  // levels beyond the last one
} Branches;

static int is_live(const Branches *branches)
{
    return !branches->levels[branches->depth].is_dead;
}

// ---- Conditions --------------------------------------------------------------------------------

typedef enum Condition { NEVER, ALWAYS, NOBODY_KNOWS } Condition;

// The condition that follows: only a number alone is known.
static Condition condition_read(SourceReader reader)
{
    const SourceWord first = source_next(&reader), second = source_next(&reader);
    char *end;
    if (!first.in_directive || first.begins_directive ||
        (second.in_directive && !second.begins_directive)) {
        return NOBODY_KNOWS;
    }
    if (source_is(&first, SOURCE_NAME, "false")) {
        return NEVER;
    }
    const unsigned long value = strtoul(first.text, &end, 0);
    const int is_number =
        first.kind == SOURCE_NUMBER && end != first.text && strspn(end, "uUlL") == strlen(end);
    return !is_number ? NOBODY_KNOWS : value != 0 ? ALWAYS : NEVER;
}

static void branch_begin(Branches *branches, Condition condition)
{
    if (branches->depth == 0 || branches->n_deeper > 0) {
        return;
    }
    Level *level = &branches->levels[branches->depth];
    level->is_dead = level[-1].is_dead || level->was_true || condition == NEVER;
    level->was_true |= condition == ALWAYS;
    level->is_unknown |= condition == NOBODY_KNOWS;
}

static void level_begin(Branches *branches, Condition condition)
{
    if (branches->depth + 1 == MOST_LEVELS) {
        branches->n_deeper++;
        return;
    }
    branches->levels[++branches->depth] = (Level){0};
    branch_begin(branches, condition);
}

// Note the directive of which the reader is behind the #.
static void directive_note(Branches *branches, SourceReader reader)
{
    const SourceWord name = source_next(&reader);
    if (source_is(&name, SOURCE_NAME, "if")) {
        level_begin(branches, condition_read(reader));
    } else if (source_is(&name, SOURCE_NAME, "ifdef") || source_is(&name, SOURCE_NAME, "ifndef")) {
        level_begin(branches, NOBODY_KNOWS);
    } else if (source_is(&name, SOURCE_NAME, "elif")) {
        branch_begin(branches, condition_read(reader));
    } else if (source_is(&name, SOURCE_NAME, "else")) {
        const Level *level = &branches->levels[branches->depth];
        branch_begin(branches, level->is_unknown ? NOBODY_KNOWS : ALWAYS);
    } else if (source_is(&name, SOURCE_NAME, "endif") && branches->n_deeper > 0) {
        branches->n_deeper--;
    } else if (source_is(&name, SOURCE_NAME, "endif")) {
        branches->depth -= branches->depth > 0;
    }
}

static int is_conditional(const Branches *branches)
{
    for (int i = 1; i <= branches->depth; i++) {
        if (branches->levels[i].is_unknown) {
            return 1;
        }
    }
    return branches->n_deeper > 0;
}

// ---- Text --------------------------------------------------------------------------------------

// Copy a piece, or of what is not compiled only the line ends. Returns the copy's end.
static char *piece_copy(char *to, const char *from, const char *end, int is_whole)
{
    for (; from < end; from++) {
        if (is_whole || *from == '\n') {
            *to++ = *from;
        }
    }
    return to;
}

char *live_text(const char *answer, LiveCount *count)
{
    char *live = memory_take(strlen(answer) + 1), *to = live;
    Branches branches = {0};
    SourceReader reader = source_reader(answer);
    const char *copied = answer;  // up to here
    int is_whole = 1;             // of the word: of a directive also where it ends what is left out
    for (;;) {
        const SourceWord word = source_next(&reader);
        const int was_live =
            word.in_directive && !word.begins_directive ? is_whole : is_live(&branches);
        if (word.begins_directive) {
            directive_note(&branches, reader);
        }
        is_whole = word.begins_directive ? was_live || is_live(&branches) : was_live;
        const char *start = word.kind == SOURCE_END ? copied + strlen(copied) : word.start;
        to = piece_copy(to, copied, start, was_live);
        if (word.kind == SOURCE_END) {
            return live;
        }
        to = piece_copy(to, start, start + word.length, is_whole);
        copied = start + word.length;
        count->n_left_out += !is_whole && !word.in_directive;
        count->n_conditional += is_whole && !word.in_directive && is_conditional(&branches);
    }
}
