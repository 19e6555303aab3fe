// Applying edits (see edits.h).
#include "edits.h"

#include "complain.h"
#include "message.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// One edit: both texts are whole lines, and owned.
typedef struct Edit {
    char *old, *new;
    int line;     // where it begins, from 0
    int n_lines;  // it has
} Edit;

// Where a text is made.
typedef struct Output {
    FILE *file;
    char *text;
    size_t n_bytes;
} Output;

static void output_open(Output *output)
{
    output->file = open_memstream(&output->text, &output->n_bytes);
    if (output->file == NULL) {
        complain("no memory for an edit");
        exit(2);
    }
}

static char *output_close(Output *output)
{
    fclose(output->file);
    return output->text;
}

// Take the next edit off *edits, with the blank lines before it. `line` counts lines.
static Edit edit_take(const char **edits, int *line)
{
    Output old, new;
    for (; **edits == '\n'; (*edits)++) {
        ++*line;
    }
    Edit edit = {.line = *line};
    output_open(&old);
    output_open(&new);
    while (**edits != '\0' && **edits != '\n') {
        const char sign = **edits;
        const int length = (int)strcspn(*edits, "\n");
        if (sign != '+') {
            fprintf(old.file, "%.*s\n", length - 1, *edits + 1);
        }
        if (sign != '-') {
            fprintf(new.file, "%.*s\n", length - 1, *edits + 1);
        }
        *edits += length + ((*edits)[length] == '\n');
        edit.n_lines++;
    }
    *line += edit.n_lines;
    edit.old = output_close(&old);
    edit.new = output_close(&new);
    return edit;
}

static void edit_free(Edit *edit)
{
    free(edit->old);
    free(edit->new);
}

// The next place from `from` on, in `text`, where these whole lines are, or NULL.
static const char *find_lines(const char *text, const char *from, const char *lines)
{
    const char *at = strstr(from, lines);
    while (at != NULL && at > text && at[-1] != '\n') {
        at = strstr(at + 1, lines);
    }
    return at;
}

// Why an edit does not fit, or NULL.
//   end   of the edit before it, in `text`
//   at    out: where it fits
static char *edit_fault(const Edit *edit, const char *text, const char *end, const char **at)
{
    *at = find_lines(text, text, edit->old);
    if (strcmp(edit->old, edit->new) == 0) {
        return message_new("the edit changes nothing");
    }
    if (edit->old[0] == '\0') {
        return message_new("the edit has no line with \"-\" or a blank: where does it belong?");
    }
    if (*at == NULL) {
        return message_new("the edit does not fit: the solution does not have these lines");
    }
    if (find_lines(text, *at + 1, edit->old) != NULL) {
        return message_new("the edit fits in two places: give it a line around it");
    }
    return *at < end ? message_new("the edit belongs before the one above it") : NULL;
}

// A text that edits replace as a whole, or NULL where they do not. Likewise owned.
static char *whole_text(const char *edits)
{
    int line = 0;
    Edit first = edit_take(&edits, &line);
    char *text = NULL;
    if (first.n_lines > 0 && first.old[0] == '\0' && edits[strspn(edits, "\n")] == '\0') {
        text = first.new;
        first.new = NULL;
    }
    edit_free(&first);
    return text;
}

char *edits_apply(const char *text, const char *edits, char **why, int *line)
{
    const char *end = text, *at = text;
    char *whole = whole_text(edits);
    *line = 0;
    *why = NULL;
    if (whole != NULL && strcmp(whole, text) == 0) {
        *why = message_new("the text is the solution's");
    } else if (whole != NULL) {
        return whole;
    }
    free(whole);
    int n_lines = 0;
    Output output;
    output_open(&output);
    while (*why == NULL && (n_lines == 0 || edits[strspn(edits, "\n")] != '\0')) {
        Edit edit = edit_take(&edits, &n_lines);
        *line = edit.line;
        *why = edit.n_lines == 0 ? message_new("no edit: nothing differs from the solution")
                                 : edit_fault(&edit, text, end, &at);
        if (*why == NULL) {
            fprintf(output.file, "%.*s%s", (int)(at - end), end, edit.new);
            end = at + strlen(edit.old);
        }
        edit_free(&edit);
    }
    fputs(end, output.file);
    char *edited = output_close(&output);
    if (*why != NULL) {
        free(edited);
        return NULL;
    }
    return edited;
}
