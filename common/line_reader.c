// Text files, line by line (see line_reader.h).
//
// Nothing in a file is trusted: how long its lines are, what its bytes are, whether it ends. Read
// next: scene3d_nff.c.
#include "line_reader.h"

#include "clean_text.h"
#include "complain.h"
#include "number.h"
#include "utf8.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>

void line_reader_begin(LineReader *reader, FILE *file, const char *name)
{
    reader->file = file;
    reader->name = name;
    reader->line = 0;
    reader->failed = 0;
    reader->unended_line = 0;
    reader->text[0] = '\0';
}

// Some editors mark a file as UTF-8 with these three bytes.
static void mark_remove(char *text, int length)
{
    if (length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) {
        memmove(text, text + 3, (size_t)length - 3 + 1);
    }
}

// A NUL byte ends the reading. Of text in UTF-16, which begins with one of two marks, every other
// byte is one: some shells write it wherever output goes to a file.
static void nul_fault(LineReader *reader, int length)
{
    const int is_marked = reader->line == 1 && length >= 2;
    if (is_marked &&
        (memcmp(reader->text, "\xFF\xFE", 2) == 0 || memcmp(reader->text, "\xFE\xFF", 2) == 0)) {
        line_fault(reader, "", "text in UTF-16", "ASCII or UTF-8: save it as such");
    } else {
        line_fault(reader, "", "a NUL byte", "text");
    }
}

// How much of `word` has been met behind one more character. It has its first letter only once.
static const char *word_go_on(const char *word, const char *next, int c)
{
    return c == *next ? next + 1 : word + (c == *word);
}

// Pass over the rest of a line that does not fit. Returns what ended it, or 0 after a complaint.
static int rest_skip(LineReader *reader, const char *word)
{
    const char *next = word;
    int c;
    // It may begin within what fits.
    for (size_t i = LINE_MAX_LENGTH + 1 - strlen(word); i < LINE_MAX_LENGTH; i++) {
        next = word_go_on(word, next, reader->text[i]);
    }
    while ((c = getc_unlocked(reader->file)) != EOF && c != '\n' && *next != '\0') {
        if (c == '\0') {
            nul_fault(reader, LINE_MAX_LENGTH);
            return 0;
        }
        next = word_go_on(word, next, c);
    }
    if (*next == '\0') {
        char found[LINE_QUOTE_SIZE];
        line_fault(reader, "", line_quote(word, found),
                   "it within the first " NUMBER_TEXT(LINE_MAX_LENGTH) " characters");
        return 0;
    }
    return c;
}

int line_read_start(LineReader *reader, const char *word)
{
    int length = 0;
    int c;
    reader->line++;
    while ((c = getc_unlocked(reader->file)) != EOF && c != '\n') {
        if (c == '\0') {
            nul_fault(reader, length);
            return 0;
        }
        if (length == LINE_MAX_LENGTH && word == NULL) {
            line_fault(reader, "", "more than " NUMBER_TEXT(LINE_MAX_LENGTH) " characters",
                       "a shorter line");
            return 0;
        }
        if (length == LINE_MAX_LENGTH) {
            ungetc(c, reader->file);
            if ((c = rest_skip(reader, word)) == 0) {
                return 0;
            }
            break;
        }
        reader->text[length++] = (char)c;
    }
    reader->text[length] = '\0';
    if (c == EOF && ferror(reader->file)) {
        line_fault(reader, "", strerror(errno), "a file that can be read");
        return 0;
    }
    if (c == EOF && length == 0) {
        return 0;
    }
    // Behind a blank no number goes on.
    if (c == EOF && strchr(" \t\r", reader->text[length - 1]) == NULL) {
        reader->unended_line = reader->line;
    }
    if (reader->line == 1) {
        mark_remove(reader->text, length);
    }
    return 1;
}

int line_read(LineReader *reader)
{
    return line_read_start(reader, NULL);
}

void line_warn(const LineReader *reader, const char *warning)
{
    char end[128] = "";
    if (reader->unended_line != 0) {
        snprintf(end, sizeof end,
                 "%sthe last line (%" PRId64
                 ") has no line end: if the file was cut there, its last "
                 "number is wrong",
                 warning[0] != '\0' ? "; " : "", reader->unended_line);
    }
    if (warning[0] != '\0' || end[0] != '\0') {
        complain("%s: warning: %s%s", reader->name, warning, end);
    }
}

void line_fault(LineReader *reader, const char *where, const char *found, const char *expected)
{
    if (!reader->failed) {
        complain("%s:%" PRId64 ": %sfound %s, expected %s", reader->name, reader->line, where,
                 found, expected);
    }
    reader->failed = 1;
}

const char *line_quote(const char *text, char *quoted)
{
    char start[LINE_QUOTE_BYTES + 1];
    size_t n = strnlen(text, LINE_QUOTE_BYTES);
    // Whole characters, which have at most four bytes.
    for (int i = 0; i < 3 && n > 0 && utf8_goes_on(text[n]); i++) {
        n--;
    }
    snprintf(start, sizeof start, "%.*s", (int)n, text);
    quoted[0] = '"';
    text_show(start, TEXT_QUOTED, quoted + 1);
    strcat(quoted, text[n] != '\0' ? "...\"" : "\"");
    return quoted;
}

int line_split(char *line, char **words, int max_words)
{
    static const char BLANKS[] = " \t\r";
    int n_words = 0;
    for (char *word = line + strspn(line, BLANKS); *word != '\0'; word += strspn(word, BLANKS)) {
        if (n_words < max_words) {
            words[n_words] = word;
        }
        n_words++;
        word += strcspn(word, BLANKS);
        if (*word != '\0') {
            *word++ = '\0';
        }
    }
    return n_words;
}
