// Text of unknown origin made fit for messages and reports (see clean_text.h).
//
// Read next: complain.c.
#include "clean_text.h"

#include "utf8.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// How a message that is too long is shared out between its beginning and its end.
enum {
    HEAD_LINES = 29,
    TAIL_LINES = 10,  // and one line between them says how many were left out
    HEAD_BYTES = 6000,
    TAIL_BYTES = 1900,
    LINE_TAIL_BYTES = 100,
};

// A grading that ran out of memory must not end with an exit status that means a grade.
static void *memory_for(size_t n_bytes)
{
    void *bytes = malloc(n_bytes);
    if (bytes == NULL) {
        fprintf(stderr, "no memory for a text of %zu bytes\n", n_bytes);
        abort();
    }
    return bytes;
}

// What is not seen: control characters (category Cc of Unicode 15.1), formats such as marks that
// make text read in another order than it is written (Cf), separators of lines (Zl, Zp), and two
// code points that stand for no character, which XML forbids.
static const struct {
    uint32_t first, last;
} unseen[] = {
    {0x0000, 0x001F},   {0x007F, 0x009F},   {0x00AD, 0x00AD},   {0x0600, 0x0605},
    {0x061C, 0x061C},   {0x06DD, 0x06DD},   {0x070F, 0x070F},   {0x0890, 0x0891},
    {0x08E2, 0x08E2},   {0x180E, 0x180E},   {0x200B, 0x200F},   {0x2028, 0x202E},
    {0x2060, 0x206F},   {0xFEFF, 0xFEFF},   {0xFFF9, 0xFFFB},   {0xFFFE, 0xFFFF},
    {0x110BD, 0x110BD}, {0x110CD, 0x110CD}, {0x13430, 0x1343F}, {0x1BCA0, 0x1BCA3},
    {0x1D173, 0x1D17A}, {0xE0001, 0xE0001}, {0xE0020, 0xE007F},
};

int character_is_unseen(uint32_t character)
{
    size_t i = 0;
    while (i < sizeof unseen / sizeof *unseen && character > unseen[i].last) {
        i++;
    }
    return i < sizeof unseen / sizeof *unseen && character >= unseen[i].first;
}

// Write each byte as \xHH. Returns the end.
static char *bytes_show(const char *bytes, int n_bytes, char *end)
{
    for (int i = 0; i < n_bytes; i++) {
        end += sprintf(end, "\\x%02X", (unsigned char)bytes[i]);
    }
    return end;
}

void text_show(const char *text, TextForm form, char *clean)
{
    char *end = clean;
    for (const char *from = text; *from != '\0';) {
        uint32_t character;
        const int length = utf8_read(from, &character);
        if (from[0] == '\r' && from[1] == '\n' && form != TEXT_QUOTED) {
            from++;
        } else if ((*from == '\n' || *from == '\t') && form != TEXT_QUOTED) {
            *end++ = form == TEXT_IN_LINES ? *from : ' ';
            from++;
        } else if (length > 0 && !character_is_unseen(character)) {
            memcpy(end, from, (size_t)length);
            end += length;
            from += length;
        } else {
            end = bytes_show(from, length > 0 ? length : 1, end);
            from += length > 0 ? length : 1;
        }
    }
    *end = '\0';
}

char *text_clean(const char *text, TextForm form)
{
    text = text != NULL ? text : "";
    char *clean = memory_for(CLEAN_TEXT_GROWTH * strlen(text) + 1);
    text_show(text, form, clean);
    return clean;
}

// Replace what stands between head and tail by a note. Frees `text`.
static char *middle_replace(char *text, size_t head, size_t tail, const char *note)
{
    size_t tail_length = strlen(text + tail);
    size_t note_length = strlen(note);
    char *shorter = memory_for(head + note_length + tail_length + 1);
    memcpy(shorter, text, head);
    memcpy(shorter + head, note, note_length);
    memcpy(shorter + head + note_length, text + tail, tail_length + 1);
    free(text);
    return shorter;
}

// At most head_bytes + tail_bytes stay, whole characters only.
static char *bytes_limit(char *text, size_t head_bytes, size_t tail_bytes)
{
    size_t length = strlen(text);
    size_t head = head_bytes;
    size_t tail = length - tail_bytes;
    while (head > 0 && utf8_goes_on(text[head])) {
        head--;
    }
    while (tail < length && utf8_goes_on(text[tail])) {
        tail++;
    }
    char note[64];
    snprintf(note, sizeof note, " [... %zu bytes left out ...] ", tail - head);
    return middle_replace(text, head, tail, note);
}

static char *lines_limit(char *text)
{
    int n_lines = 1;
    for (const char *at = text; (at = strchr(at, '\n')) != NULL; at++) {
        n_lines++;
    }
    if (n_lines <= MESSAGE_MAX_LINES) {
        return text;
    }

    const char *head = text;
    const char *tail = text;
    for (int i = 0; i < n_lines - TAIL_LINES; i++) {
        if (i == HEAD_LINES) {
            head = tail;
        }
        tail = strchr(tail, '\n') + 1;
    }
    char note[64];
    snprintf(note, sizeof note, "[... %d lines left out ...]\n", n_lines - HEAD_LINES - TAIL_LINES);
    return middle_replace(text, (size_t)(head - text), (size_t)(tail - text), note);
}

char *message_clean(const char *message)
{
    char *text = text_clean(message, TEXT_IN_LINES);
    for (size_t length = strlen(text); length > 0 && text[length - 1] == '\n'; length--) {
        text[length - 1] = '\0';
    }
    text = lines_limit(text);
    if (strlen(text) > MESSAGE_MAX_BYTES) {
        text = bytes_limit(text, HEAD_BYTES, TAIL_BYTES);
    }
    return text;
}

char *line_clean(const char *line)
{
    char *text = text_clean(line, TEXT_IN_A_LINE);
    if (strlen(text) > LINE_MAX_BYTES) {
        text = bytes_limit(text, LINE_MAX_BYTES - LINE_TAIL_BYTES, LINE_TAIL_BYTES);
    }
    return text;
}
