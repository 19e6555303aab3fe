// The operators, one function each, over the words of a text. What is taken for what stands in
// mutation_tables.h.
#include "mutations.h"

#include "message.h"
#include "mutation_tables.h"
#include "source_words.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A text while its mutations are found.
typedef struct Search {
    const char *text;
    const SourceWord *words;  // of the text, directives apart
    int n;
    Mutations *found;
    int failed;  // memory ran out
} Search;

// ---- Adding -------------------------------------------------------------------------------------

// Replace words first ... last. Takes over `replacement`.
static void add(Search *search, int first, int last, const char *name, const char *new_word,
                char *replacement)
{
    Mutations *found = search->found;
    Mutation *all = realloc(found->all, ((size_t)found->n + 1) * sizeof *all);
    found->all = all != NULL ? all : found->all;
    if (all == NULL || replacement == NULL) {
        free(replacement);
        search->failed = 1;
        return;
    }
    const SourceWord from = search->words[first], to = search->words[last];
    Mutation *mutation = &all[found->n++];
    *mutation = (Mutation){.start = (size_t)(from.start - search->text),
                           .length = (size_t)(to.start + to.length - from.start),
                           .replacement = replacement};
    snprintf(mutation->id, sizeof mutation->id, "%d:%s:%.*s%s%s", first, name,
             (int)(from.length < 32 ? from.length : 32), from.start, new_word[0] ? ":" : "",
             new_word);
}

// Replace one word by a word.
static void add_word(Search *search, int at, const char *name, const char *word)
{
    add(search, at, at, name, word, strdup(word));
}

// The text from word `first` to word `last`, as a precision and a pointer for "%.*s".
static int span(const Search *search, int first, int last)
{
    const SourceWord to = search->words[last];
    return (int)(to.start + to.length - search->words[first].start);
}

// ---- Finding one's way --------------------------------------------------------------------------

static int is(const Search *search, int at, const char *words)
{
    return at >= 0 && at < search->n && source_is_one_of(&search->words[at], words);
}

// The bracket that closes the one at `open`, or n when none does.
static int closing(const Search *search, int open)
{
    int depth = 0;
    for (int i = open; i < search->n; i++) {
        depth += is(search, i, "( [ {");
        depth -= is(search, i, ") ] }");
        if (depth == 0) {
            return i;
        }
    }
    return search->n;
}

// Is the word at `at` the end of a term, so that a + behind it stands between two?
static int ends_term(const Search *search, int at)
{
    if (at < 0) {
        return 0;
    }
    const SourceKind kind = search->words[at].kind;
    return kind == SOURCE_SIGN ? is(search, at, ") ]")
                               : !is(search, at, "return case else const sizeof");
}

static int is_call(const Search *search, int at)
{
    return search->words[at].kind == SOURCE_NAME && is(search, at + 1, "(") &&
           !is(search, at, "if for while switch return sizeof");
}

// ---- The operators ------------------------------------------------------------------------------

// Every replacement that a table has for the word at `at`.
static void add_from_table(Search *search, int at, const char *name, const char *const table[][2],
                           size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (source_is_one_of(&search->words[at], table[i][0])) {
            add_word(search, at, name, table[i][1]);
        }
    }
}

#define N_OF(table) (sizeof(table) / sizeof *(table))

// Only a vector or a structure has a z.
static void find_names(Search *search, int at)
{
    add_from_table(search, at, "name", NAMES, N_OF(NAMES));
    if (is(search, at - 1, ". ->")) {
        add_from_table(search, at, "name", MEMBERS, N_OF(MEMBERS));
    }
}

static void find_operators(Search *search, int at)
{
    if (is(search, at, "++ --") || ends_term(search, at - 1)) {
        add_from_table(search, at, "operator", OPERATORS, N_OF(OPERATORS));
    } else if (is(search, at, "- !")) {
        add(search, at, at, "operator", "none", strdup(""));
    }
    add_from_table(search, at, "compare", COMPARISONS, N_OF(COMPARISONS));
}

static void find_constants(Search *search, int at)
{
    const SourceWord constant = search->words[at];
    char *end, word[64];
    if (constant.kind == SOURCE_NAME) {
        int is_constant = isupper((unsigned char)constant.start[0]) != 0;
        for (size_t i = 0; i < constant.length; i++) {
            is_constant &= !islower((unsigned char)constant.start[i]);
        }
        if (source_is_one_of(&constant, "INFINITY")) {
            add_word(search, at, "constant", "0.0f");
        } else if (is_constant && !is_call(search, at) && !source_is_one_of(&constant, "NULL")) {
            add(search, at, at, "constant", "+1",
                message_new("(%.*s + 1)", span(search, at, at), constant.start));
        }
        return;
    }
    const int is_whole = memchr(constant.start, '.', constant.length) == NULL;
    const double value =
        is_whole ? (double)strtoul(constant.start, &end, 0) : strtod(constant.start, &end);
    const int ending = (int)(constant.start + constant.length - end);
    const double others[] = {value + 1, is_whole ? value - 1 : 2 * value, 0};
    for (size_t i = 0; i < N_OF(others); i++) {
        const int is_repeated = i > 0 && (others[i] == value || (i == 2 && others[1] == 0));
        if (is_repeated || others[i] < 0) {
            continue;
        }
        snprintf(word, sizeof word, is_whole ? "%.0f%.*s" : "%#.9g%.*s", others[i], ending, end);
        add_word(search, at, "constant", word);
    }
}

// Swap each argument with the next one; `open` is the list's bracket.
static void find_swaps(Search *search, int open)
{
    const int close = closing(search, open);
    int before = -1, start = open + 1, number = 0;  // the argument before, and the one at hand
    for (int i = open + 1; i <= close && close < search->n; i++) {
        if (is(search, i, "( [ {")) {
            i = closing(search, i);
            continue;
        }
        if (i < close && !is(search, i, ",")) {
            continue;
        }
        const char *const a = before >= 0 ? search->words[before].start : NULL;
        const char *const b = search->words[start].start;
        if (before >= 0 && start < i) {
            const int n_a = span(search, before, start - 2), n_b = span(search, start, i - 1);
            if (n_a != n_b || memcmp(a, b, (size_t)n_a) != 0) {
                char word[16];
                snprintf(word, sizeof word, "%d", number);
                add(search, before, i - 1, "swap", word, message_new("%.*s, %.*s", n_b, b, n_a, a));
            }
        }
        before = start;
        start = i + 1;
        number++;
    }
}

static void find_calls(Search *search, int at)
{
    const int is_list = is(search, at, "{") && is(search, at - 1, "= ) ,");
    const int is_literal = is(search, at, "(") && is(search, at - 1, ")");
    if (is_list || is_literal) {
        find_swaps(search, at);
    }
    if (!is_call(search, at)) {
        return;
    }
    // Where the order does not count there is nothing to swap.
    if (!is(search, at, "fmin fmax fminf fmaxf min max dot vec3_dot")) {
        find_swaps(search, at + 1);
    }
    const int close = closing(search, at + 1);
    int n_commas = 0;
    for (int i = at + 2; i < close; i++) {
        i = is(search, i, "( [ {") ? closing(search, i) : i;
        n_commas += is(search, i, ",");
    }
    if (n_commas == 0 && close > at + 2) {
        add(search, at, at, "unwrap", "", strdup(""));
    }
}

// Does the bracket at `close` end the head of an if or a loop?
static int ends_head(const Search *search, int close)
{
    int depth = 0;
    for (int i = close; i >= 0; i--) {
        depth += is(search, i, ") ]");
        depth -= is(search, i, "( [");
        if (depth == 0) {
            return is(search, i - 1, "if for while switch");
        }
    }
    return 0;
}

// Does the colon at `colon` end a label? Else it belongs to a ?.
static int ends_label(const Search *search, int colon)
{
    int i = colon;
    while (i >= 0 && !is(search, i, "; { } ?")) {
        i--;
    }
    return !is(search, i, "?");
}

// May a statement that is no declaration start at `at`?
static int starts_statement(const Search *search, int at)
{
    const int is_behind = at == 0 || is(search, at - 1, "; { } else") ||
                          (is(search, at - 1, ")") && ends_head(search, at - 1)) ||
                          (is(search, at - 1, ":") && ends_label(search, at - 1));
    const int is_declaration =
        search->words[at].kind == SOURCE_NAME && at + 1 < search->n && !is(search, at, "return") &&
        (search->words[at + 1].kind == SOURCE_NAME || is(search, at + 1, "*"));
    return is_behind && !is_declaration &&
           !is(search, at, "; { } ) ] if for while switch else case default const");
}

// A statement up to its semicolon, or a block of several.
static void find_drops(Search *search, int at)
{
    if (is(search, at, "{") && is(search, at - 1, ") else")) {
        const int close = closing(search, at);
        int n_statements = 0;
        for (int i = at; i < close; i++) {
            n_statements += is(search, i, ";");
        }
        if (n_statements > 1) {
            add(search, at, close, "drop", "", strdup("{\n}"));
        }
    }
    if (!starts_statement(search, at)) {
        return;
    }
    int end = at;
    while (end < search->n && !is(search, end, ";")) {
        if (is(search, end, ") ] } :")) {
            return;  // not a statement: inside brackets, or a label
        }
        end = is(search, end, "( [ {") ? closing(search, end) + 1 : end + 1;
    }
    // Without its last return a function returns whatever was there: no two machines agree on that.
    if (end < search->n && !(is(search, at, "return") && end == search->n - 1)) {
        add(search, at, end, "drop", "", strdup(";"));
    }
}

static void add_negation(Search *search, int first, int last, int named)
{
    if (first > last || last >= search->n) {
        return;
    }
    const char *start = search->words[first].start;
    char word[16];
    snprintf(word, sizeof word, "%.*s", span(search, named, named), search->words[named].start);
    add(search, first, last, "negate", word,
        message_new("!(%.*s)", span(search, first, last), start));
}

static void find_negations(Search *search, int at)
{
    if (is(search, at, "if while") && is(search, at + 1, "(")) {
        add_negation(search, at + 2, closing(search, at + 1) - 1, at);
    } else if (is(search, at, "?")) {
        int first = at;
        for (int depth = 0; first > 0; first--) {
            depth += is(search, first - 1, ") ]");
            depth -= is(search, first - 1, "( [");
            if (depth < 0 || (depth == 0 && is(search, first - 1, "= , ; { } return : += -="))) {
                break;
            }
        }
        add_negation(search, first, at - 1, at);
    }
}

// ---- All of them --------------------------------------------------------------------------------

int mutations_find(const char *text, Mutations *mutations)
{
    *mutations = (Mutations){0};
    Search search = {.text = text, .found = mutations};
    SourceWord *words = source_words(text, &search.n);
    search.words = words;
    search.failed = words == NULL;
    for (int i = 0; i < search.n; i++) {
        if (words[i].kind == SOURCE_STRING || words[i].kind == SOURCE_CHARACTER) {
            continue;
        }
        find_drops(&search, i);
        find_negations(&search, i);
        find_calls(&search, i);
        if (words[i].kind == SOURCE_SIGN) {
            find_operators(&search, i);
        } else {
            find_constants(&search, i);
            find_names(&search, i);
        }
    }
    free(words);
    if (search.failed) {
        mutations_free(mutations);
    }
    return search.failed ? -1 : 0;
}

void mutations_free(Mutations *mutations)
{
    for (int i = 0; i < mutations->n; i++) {
        free(mutations->all[i].replacement);
    }
    free(mutations->all);
    *mutations = (Mutations){0};
}

char *mutation_apply(const char *text, const Mutation *mutation)
{
    return message_new("%.*s%s%s", (int)mutation->start, text, mutation->replacement,
                       text + mutation->start + mutation->length);
}
