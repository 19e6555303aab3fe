// Operator precedence parsing into one order (see expression.h).
#include "expression.h"

#include "form_list.h"
#include "message.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

// Deeper brackets are read as they are written.
enum { MAX_DEPTH = 100 };

// What `i++` writes twice, as in `i = i + 1`, has at most so many bytes. Of a+++++++... each sign
// would otherwise double it.
enum { MAX_TWICE = 200 };

typedef struct Parser {
    const SourceWord *words;
    int at, end;
    int depth;
    const OwnNames *own;
} Parser;

void own_names_add(OwnNames *own, const SourceWord *name, int is_called)
{
    if (own->given != NULL && name_set_has(own->given, name->text)) {
        return;
    }
    if (own->names.n >= OWN_NAMES_MAX) {
        own->is_full = 1;
        return;
    }
    name_set_add(&own->names, name->text);
    if (is_called) {
        name_set_add(&own->called, name->text);
    }
}

int own_names_have(const OwnNames *own, const SourceWord *word, int is_called)
{
    return name_set_has(is_called ? &own->called : &own->names, word->text);
}

void own_names_free(OwnNames *own)
{
    name_set_free(&own->names);
    name_set_free(&own->called);
}

int is_qualifier(const SourceWord *word)
{
    return word->kind == SOURCE_NAME &&
           source_is_one_of(word,
                            "const volatile restrict register static inline auto global local "
                            "private constant __global __local __private __constant __const "
                            "__restrict read_only write_only struct");
}

int is_type_name(const SourceWord *word)
{
    static const char types[] =
        "void bool char uchar short ushort int uint long ulong float double "
        "half size_t ptrdiff_t unsigned signed int8_t uint8_t int16_t "
        "uint16_t int32_t uint32_t int64_t uint64_t u8 u16 u32 u64 i32 f32";
    SourceWord base = *word;
    if (word->kind != SOURCE_NAME) {
        return 0;
    }
    if (source_is_one_of(word, types)) {
        return 1;
    }
    while (base.length > 1 && isdigit((unsigned char)base.start[base.length - 1])) {
        base.length--;
    }
    int has_small = 0;
    for (size_t i = 0; i < strlen(word->text); i++) {
        has_small |= islower((unsigned char)word->text[i]) != 0;
    }
    return source_is_one_of(&base, types) || (isupper((unsigned char)word->text[0]) && has_small);
}

// ---- Words -----------------------------------------------------------------------------------

static const SourceWord *word_at(const Parser *parser, int ahead)
{
    static const SourceWord none = {.kind = SOURCE_END};
    return parser->at + ahead < parser->end ? &parser->words[parser->at + ahead] : &none;
}

static int next_is(const Parser *parser, const char *sign)
{
    return source_is(word_at(parser, 0), SOURCE_SIGN, sign);
}

static int take_sign(Parser *parser, const char *sign)
{
    const int is_there = next_is(parser, sign);
    parser->at += is_there;
    return is_there;
}

// 1.0f, 1.f, 1.0 and 1 are one number; so are 0x10 and 16u.
static char *number_form(const SourceWord *word)
{
    char *end;
    const double value = strtod(word->text, &end);
    return end != word->text && strspn(end, "fFuUlLhH") == strlen(end)
               ? message_new("%.9g", value)
               : message_new("%s", word->text);
}

// The form of the next word, which is taken.
static char *word_read(Parser *parser)
{
    const SourceWord *word = word_at(parser, 0);
    parser->at++;
    switch (word->kind) {
    case SOURCE_NUMBER:
        return number_form(word);
    case SOURCE_STRING:
        return message_new("\"%s\"", word->text);
    case SOURCE_CHARACTER:
        return message_new("'%s'", word->text);
    default:
        return message_new(
            "%s", own_names_have(parser->own, word, next_is(parser, "(")) ? "_" : word->text);
    }
}

// ---- Operands --------------------------------------------------------------------------------

static char *binary_read(Parser *parser, int lowest);

// Items up to the closing sign, which is taken.
static FormList items_read(Parser *parser, const char *closing)
{
    FormList list = {0};
    while (parser->at < parser->end && !take_sign(parser, closing)) {
        const int before = parser->at;
        if (!take_sign(parser, ",")) {
            form_list_add(&list, binary_read(parser, 1));
        }
        parser->at += parser->at == before;  // a sign that nothing begins with
    }
    return list;
}

// After "(": does a type stand there, and something that it is a cast of behind ")"?
static int is_cast(const Parser *parser)
{
    int n = 0, n_types = 0;
    for (;; n++) {
        const SourceWord *word = word_at(parser, n);
        n_types += is_type_name(word);
        if (!is_type_name(word) && !is_qualifier(word) && !source_is(word, SOURCE_SIGN, "*")) {
            break;
        }
    }
    const SourceWord *next = word_at(parser, n + 1);
    return n_types > 0 && source_is(word_at(parser, n), SOURCE_SIGN, ")") &&
           (next->kind != SOURCE_SIGN || source_is_one_of(next, "( { - ! ~ & *"));
}

static char *type_read(Parser *parser)
{
    FormList words = {0};
    for (; !next_is(parser, ")") && parser->at < parser->end; parser->at++) {
        if (!is_qualifier(word_at(parser, 0))) {
            form_list_add(&words, message_new("%s", word_at(parser, 0)->text));
        }
    }
    take_sign(parser, ")");
    return form_list_bare(&words);
}

static char *unary_read(Parser *parser);

static char *bracket_read(Parser *parser)
{
    if (is_cast(parser)) {
        char *type = type_read(parser);
        return form_of("cast", type, unary_read(parser), 0);
    }
    FormList list = items_read(parser, ")");
    return form_list_bare(&list);  // brackets around one thing say nothing
}

static char *primary_read(Parser *parser)
{
    if (parser->at >= parser->end) {
        return message_new("%s", "");
    }
    if (take_sign(parser, "(")) {
        return bracket_read(parser);
    }
    if (take_sign(parser, "{")) {
        FormList list = items_read(parser, "}");
        return form_list_text("{}", &list, 0);
    }
    return word_read(parser);
}

static char *step_form(char *what, const char *sign)
{
    if (strlen(what) > MAX_TWICE) {
        return form_of(sign, what, NULL, 0);
    }
    char *again = message_new("%s", what);
    char *one = message_new("%s", sign[0] == '+' ? "1" : "-(1)");
    return form_of("=", what, form_of("+", again, one, 1), 0);
}

static char *postfix_read(Parser *parser)
{
    char *form = primary_read(parser);
    while (parser->at < parser->end) {
        if (take_sign(parser, "(")) {
            FormList arguments = items_read(parser, ")");
            char *called = form;
            form = form_list_text(called, &arguments, 0);
            free(called);
        } else if (take_sign(parser, "[")) {
            form = form_of("[]", form, binary_read(parser, 0), 0);
            take_sign(parser, "]");
        } else if (next_is(parser, ".") || next_is(parser, "->")) {
            parser->at++;
            char *member = message_new("%s", word_at(parser, 0)->text);
            parser->at += parser->at < parser->end;
            form = form_of(".", form, member, 0);
        } else if (next_is(parser, "++") || next_is(parser, "--")) {
            form = step_form(form, word_at(parser, 0)->text);
            parser->at++;
        } else {
            break;
        }
    }
    return form;
}

static char *unary_read(Parser *parser)
{
    const SourceWord *word = word_at(parser, 0);
    if (word->kind != SOURCE_SIGN || !source_is_one_of(word, "- + ! ~ * & ++ --") ||
        parser->depth > MAX_DEPTH) {
        return postfix_read(parser);
    }
    parser->at++;
    parser->depth++;
    char *operand = unary_read(parser);
    parser->depth--;
    if (word->length == 2) {
        return step_form(operand, word->text);
    }
    return word->text[0] == '+' ? operand : form_of(word->text, operand, NULL, 0);
}

// ---- Operators -------------------------------------------------------------------------------

enum { LEVEL_COMMA = 0, LEVEL_ASSIGN = 1, LEVEL_CHOICE = 2, LEVEL_SUM = 10 };

// How strongly a sign binds, or -1 where it is no operator between two operands.
static int level_of(const SourceWord *word)
{
    static const char *const levels[] = {",",     "= += -= *= /= %= <<= >>= &= ^= |=",
                                         "?",     "||",
                                         "&&",    "|",
                                         "^",     "&",
                                         "== !=", "< > <= >=",
                                         "<< >>", "+ -",
                                         "* / %"};
    for (int i = 0; word->kind == SOURCE_SIGN && i < (int)(sizeof levels / sizeof *levels); i++) {
        if (source_is_one_of(word, levels[i])) {
            return i;
        }
    }
    return -1;
}

// left = right, also of `left += right`.
static char *assignment_form(const char *sign, char *left, char *right)
{
    if (strcmp(sign, "=") == 0 || strlen(left) > MAX_TWICE) {
        return form_of(sign, left, right, 0);
    }
    char operator[4] = "";
    memcpy(operator, sign, strlen(sign) - 1);
    char *again = message_new("%s", left);
    if (operator[0] == '-') {
        operator[0] = '+';
        right = form_of("-", right, NULL, 0);
    }
    const int is_sorted = strchr("+*&|^", operator[0]) != NULL;
    return form_of("=", left, form_of(operator, again, right, is_sorted), 0);
}

static char *comparison_form(const char *sign, char *left, char *right)
{
    return sign[0] == '>' ? form_of(sign[1] == '=' ? "<=" : "<", right, left, 0)
                          : form_of(sign, left, right, 0);
}

// All operands of a sum, a product, or of && and the like, to the right of the first one, in one
// order: a - b is the sum of a and -(b).
static char *chain_read(Parser *parser, char *first, int level)
{
    const char *sign = word_at(parser, 0)->text;
    const int is_sum = strcmp(sign, "-") == 0 || strcmp(sign, "+") == 0;
    const char *name = is_sum ? "+" : sign;
    FormList list = {0};
    form_list_add(&list, first);
    while (level_of(word_at(parser, 0)) == level &&
           (is_sum || strcmp(word_at(parser, 0)->text, sign) == 0)) {
        const int is_minus = next_is(parser, "-");
        parser->at++;
        char *operand = binary_read(parser, level + 1);
        form_list_add(&list, is_minus ? form_of("-", operand, NULL, 0) : operand);
    }
    return form_list_text(name, &list, 1);
}

static char *choice_read(Parser *parser, char *condition)
{
    parser->at++;
    FormList list = {0};
    form_list_add(&list, condition);
    form_list_add(&list, binary_read(parser, LEVEL_ASSIGN));
    take_sign(parser, ":");
    form_list_add(&list, binary_read(parser, LEVEL_ASSIGN));
    return form_list_text("?", &list, 0);
}

// An expression of operators that bind at least as strongly as `lowest`.
static char *binary_read(Parser *parser, int lowest)
{
    if (parser->depth > MAX_DEPTH) {
        return primary_read(parser);
    }
    parser->depth++;
    char *form = unary_read(parser);
    for (;;) {
        const SourceWord *word = word_at(parser, 0);
        const int level = level_of(word);
        if (level < lowest) {
            break;
        }
        if (level == LEVEL_ASSIGN) {
            parser->at++;
            form = assignment_form(word->text, form, binary_read(parser, LEVEL_ASSIGN));
        } else if (level == LEVEL_CHOICE) {
            form = choice_read(parser, form);
        } else if (source_is_one_of(word, "+ - * && || & | ^ == !=")) {
            form = chain_read(parser, form, level);
        } else {
            parser->at++;
            char *right = binary_read(parser, level + 1);
            form = source_is_one_of(word, "< > <= >=") ? comparison_form(word->text, form, right)
                                                       : form_of(word->text, form, right, 0);
        }
    }
    parser->depth--;
    return form;
}

// ---- All -------------------------------------------------------------------------------------

static char *words_form(Parser parser)
{
    FormList list = {0};
    while (parser.at < parser.end) {
        form_list_add(&list, word_read(&parser));
    }
    return form_list_bare(&list);
}

char *expression_form(const SourceWord words[], int from, int to, const OwnNames *own, int *is_cut)
{
    Parser parser = {words, from, to, 0, own};
    const Parser start = parser;
    FormList list = {0};
    if (to - from > EXPRESSION_MAX_WORDS) {
        *is_cut = 1;
        return words_form(start);
    }
    while (parser.at < to) {
        const int before = parser.at;
        form_list_add(&list, binary_read(&parser, LEVEL_COMMA));
        parser.at += parser.at == before;  // a sign that nothing begins with
    }
    char *form = form_list_bare(&list);
    if (strlen(form) <= EXPRESSION_MAX_BYTES) {
        return form;
    }
    free(form);
    *is_cut = 1;
    return words_form(start);
}
