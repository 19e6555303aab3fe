// Finding comments and blanks between the words of a source (see forms_parts.h).
#include "forms_parts.h"

#include "form_list.h"
#include "message.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static int is_letter(char character)
{
    return isalnum((unsigned char)character) || (unsigned char)character >= 0x80;
}

// The words of a comment in small letters, one blank between them. Returns how many there are.
static int words_fold(const char *start, const char *end, char *folded)
{
    int n = 0;
    while (start < end) {
        if (!is_letter(*start)) {
            start++;
            continue;
        }
        folded = n > 0 ? stpcpy(folded, " ") : folded;
        for (; start < end && is_letter(*start); start++) {
            *folded++ = (char)tolower((unsigned char)*start);
        }
        n++;
    }
    *folded = '\0';
    return n;
}

static int count_lines(const char *from, const char *to)
{
    int n = 0;
    for (; from < to; from++) {
        n += *from == '\n';
    }
    return n;
}

static void remark_add(Forms *forms, const char *start, const char *end, int line)
{
    char *folded = memory_take((size_t)(end - start) + 2);
    const int n_words = words_fold(start, end, folded);
    if (n_words < REMARK_MIN_WORDS) {
        free(folded);
        return;
    }
    forms_add(forms, FORM_COMMENT, folded, line, line + count_lines(start, end));
}

// What stands between two words: blanks and comments.
static void gap_read(Forms *forms, const char *from, const char *to, int line)
{
    while (from < to) {
        const int is_line = strncmp(from, "//", 2) == 0, is_block = strncmp(from, "/*", 2) == 0;
        if (!is_line && !is_block) {
            line += *from++ == '\n';
            continue;
        }
        const size_t n_left = (size_t)(to - from);
        const char *end = is_line      ? memchr(from, '\n', n_left)
                          : n_left > 2 ? memmem(from + 2, n_left - 2, "*/", 2)
                                       : NULL;
        end = end == NULL ? to : end;
        remark_add(forms, from, end, line);
        line += count_lines(from, end);
        from = end;
    }
}

static int is_blank(char character)
{
    return character == ' ' || character == '\t';
}

// The blanks between two words, where they are odd.
static void blanks_read(Forms *forms, const SourceWord *before, const SourceWord *behind,
                        const OwnNames *own, int line)
{
    const char *from = before->start + before->length;
    int n = 0, n_tabs = 0;
    for (; is_blank(from[n]); n++) {
        n_tabs += from[n] == '\t';
    }
    const int at_end = from[n] == '\n' || from[n] == '\r';
    const int is_next = behind->kind != SOURCE_END && from + n == behind->start;
    const int is_odd =
        at_end ? n > 0 : is_next && (n > 1 || (n == 1 && source_is_one_of(behind, "; ,")));
    if (is_odd) {
        forms_add(forms, FORM_BLANKS,
                  message_new("%d blanks, %d tabs, after %s before %s", n - n_tabs, n_tabs,
                              own_names_have(own, before, 0) ? "_" : before->text,
                              at_end                           ? "the line's end"
                              : own_names_have(own, behind, 0) ? "_"
                                                               : behind->text),
                  line, line);
    }
}

void remarks_read(const char *answer, const OwnNames *own, Forms *forms)
{
    SourceReader reader = source_reader(answer);
    SourceWord last = {.kind = SOURCE_END, .start = answer};
    int line = 1;
    for (;;) {
        const SourceWord word = source_next(&reader);
        const char *from = last.start + last.length;
        const char *start = word.kind == SOURCE_END ? from + strlen(from) : word.start;
        if (last.kind != SOURCE_END) {
            blanks_read(forms, &last, &word, own, line);
        }
        gap_read(forms, from, start, line);
        if (word.kind == SOURCE_END) {
            break;
        }
        line += count_lines(from, word.start + word.length);
        last = word;
    }
}
