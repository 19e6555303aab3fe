// Filling in templates (see template.h).
#include "template.h"

#include "clean_text.h"
#include "complain.h"
#include "html.h"

#include <stdlib.h>
#include <string.h>

// Objects whose names can be seen, the innermost first.
typedef struct Scope {
    const json_t *values;
    const struct Scope *outer;
    size_t i, n;  // which of how many of a list; n is 0 where it is in none
} Scope;

typedef struct Tag {
    const char *begin, *end;  // of all of it, with the line where it stands alone
    char kind;                // '#', '^', '/', '{' or ' '
    char name[32];
} Tag;

// Of the innermost list.
static const json_t *place_of(const Scope *scope, const char *name)
{
    while (scope != NULL && scope->n == 0) {
        scope = scope->outer;
    }
    return json_boolean(scope != NULL &&
                        (strcmp(name, "is_first") == 0  ? scope->i == 0
                         : strcmp(name, "is_next") == 0 ? scope->i > 0
                                                        : scope->i + 1 == scope->n));
}

static const json_t *value_of(const Scope *scope, const char *name)
{
    const json_t *value = NULL;
    if (strcmp(name, "is_first") == 0 || strcmp(name, "is_next") == 0 ||
        strcmp(name, "is_last") == 0) {
        return place_of(scope, name);
    }
    for (; scope != NULL && value == NULL; scope = scope->outer) {
        value = json_object_get(scope->values, name);
    }
    return value;
}

static int is_nothing(const json_t *value)
{
    return value == NULL || json_is_null(value) || json_is_false(value) ||
           (json_is_array(value) && json_array_size(value) == 0) ||
           (json_is_string(value) && json_string_length(value) == 0);
}

// The next tag; 0 where there is none. A template is ours: it has no other braces.
static int tag_find(const char *at, const char *end, const char *text, Tag *tag)
{
    const char *begin = strstr(at, "{{");
    if (begin == NULL || begin >= end) {
        return 0;
    }
    const char *name = begin + 2;
    tag->kind = strchr("#^/{", *name) != NULL ? *name++ : ' ';
    const size_t n_name = strcspn(name, "}");
    snprintf(tag->name, sizeof tag->name, "%.*s", (int)n_name, name);
    tag->begin = begin;
    tag->end = name + n_name + (tag->kind == '{' ? 3 : 2);
    const int is_alone = (begin == text || begin[-1] == '\n') && *tag->end == '\n';
    tag->end += is_alone && strchr("#^/", tag->kind) != NULL;
    return 1;
}

static void part_write(FILE *page, const char *text, const char *begin, const char *end,
                       const Scope *scope);

// A part for its value. Returns where it goes on behind the part.
static const char *section_write(FILE *page, const char *text, const char *end, const Tag *begin,
                                 const Scope *scope)
{
    const json_t *value = value_of(scope, begin->name);
    Tag last = *begin;
    for (int depth = 1; depth > 0 && tag_find(last.end, end, text, &last);) {
        if (strcmp(last.name, begin->name) == 0) {
            depth += last.kind == '/' ? -1 : last.kind == '#' || last.kind == '^';
        }
    }
    if (is_nothing(value) != (begin->kind == '^')) {
        return last.end;
    }
    const size_t n = json_is_array(value) && begin->kind == '#' ? json_array_size(value) : 1;
    for (size_t i = 0; i < n; i++) {
        const int is_list = json_is_array(value);
        const Scope inner = {is_list ? json_array_get(value, i) : value, scope, i, is_list ? n : 0};
        part_write(page, text, begin->end, last.begin,
                   json_is_object(inner.values) ? &inner : scope);
    }
    return last.end;
}

static void part_write(FILE *page, const char *text, const char *begin, const char *end,
                       const Scope *scope)
{
    Tag tag;
    while (tag_find(begin, end, text, &tag)) {
        fwrite(begin, 1, (size_t)(tag.begin - begin), page);
        const json_t *value = value_of(scope, tag.name);
        begin = tag.end;
        if (tag.kind == '#' || tag.kind == '^') {
            begin = section_write(page, text, end, &tag, scope);
        } else if (json_is_integer(value)) {
            fprintf(page, "%" JSON_INTEGER_FORMAT, json_integer_value(value));
        } else if (json_is_string(value) && tag.kind == '{') {
            fputs(json_string_value(value), page);
        } else if (json_is_string(value)) {
            html_line(page, json_string_value(value));
        }
    }
    fwrite(begin, 1, (size_t)(end - begin), page);
}

int template_write(FILE *page, const char *text, json_t *values)
{
    if (values == NULL) {
        complain("gradebook: out of memory for a page");
        return -1;
    }
    part_write(page, text, text, text + strlen(text), &(Scope){values, NULL, 0, 0});
    json_decref(values);
    return 0;
}

int template_commit(OutputFile *output, int failed)
{
    if (failed) {
        output_file_discard(output);
        return -1;
    }
    return output_file_commit(output);
}

json_t *template_line(const char *text)
{
    // html_line() cuts what is too long.
    char *line = text_clean(text != NULL ? text : "", TEXT_IN_A_LINE);
    json_t *value = json_string(line);
    free(line);
    return value;
}

json_t *template_markup(void (*write)(FILE *file, const void *about), const void *about)
{
    char *markup = NULL;
    size_t length;
    FILE *file = open_memstream(&markup, &length);
    if (file != NULL) {
        write(file, about);
        fclose(file);
    }
    json_t *value = json_string(markup != NULL ? markup : "");
    free(markup);
    return value;
}

static void bar_write(FILE *file, const void *about)
{
    const int *parts = about;
    html_score_bar(file, parts[0], parts[1]);
}

json_t *template_bar(int points, int max_points)
{
    return template_markup(bar_write, (const int[]){points, max_points});
}
