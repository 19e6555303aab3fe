// Finding comments between the words of a source (see remarks.h).
#include "remarks.h"

#include "form_list.h"
#include "source_words.h"

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
        const char *end = is_line ? strchr(from, '\n') : strstr(from + 2, "*/");
        end = end == NULL || end > to ? to : end;
        remark_add(forms, from, end, line);
        line += count_lines(from, end);
        from = end;
    }
}

void remarks_read(const char *answer, Forms *forms)
{
    SourceReader reader = source_reader(answer);
    const char *last = answer;
    int line = 1;
    for (;;) {
        const SourceWord word = source_next(&reader);
        const char *start = word.kind == SOURCE_END ? last + strlen(last) : word.start;
        gap_read(forms, last, start, line);
        if (word.kind == SOURCE_END) {
            break;
        }
        line += count_lines(last, word.start + word.length);
        last = word.start + word.length;
    }
}
