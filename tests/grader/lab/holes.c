// Holes, found line by line: a marker is a line of its own, whatever stands before it but blanks.
#include "holes.h"

#include "complain.h"
#include "message.h"
#include "text_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A line of a text, without its newline.
typedef struct Line {
    const char *start;
    size_t length;
} Line;

// Take the next line off *text. Returns 0 at the end.
static int next_line(const char **text, Line *line)
{
    if (**text == '\0') {
        return 0;
    }
    line->start = *text;
    line->length = strcspn(*text, "\n");
    *text += line->length + ((*text)[line->length] == '\n');
    return 1;
}

// The text of a line behind its blanks and `prefix`, or NULL when it starts otherwise.
static const char *after_prefix(Line line, const char *prefix)
{
    const char *text = line.start;
    const char *end = line.start + line.length;
    while (text < end && (*text == ' ' || *text == '\t')) {
        text++;
    }
    const size_t length = strlen(prefix);
    return (size_t)(end - text) >= length && memcmp(text, prefix, length) == 0 ? text + length
                                                                               : NULL;
}

// Does the line mark the begin ("// TASK id:") or the end ("// END id") of a hole? Copies the id.
static int is_marker(Line line, const char *word, char id[HOLE_ID_BYTES])
{
    const char *name = after_prefix(line, word);
    if (name == NULL) {
        return 0;
    }
    const size_t rest = (size_t)(line.start + line.length - name);
    size_t length = 0;
    while (length < rest && strchr(": \t\r", name[length]) == NULL) {
        length++;
    }
    if (length == 0 || length >= HOLE_ID_BYTES) {
        return 0;
    }
    memcpy(id, name, length);
    id[length] = '\0';
    return 1;
}

static int is_begin(Line line, char id[HOLE_ID_BYTES])
{
    return is_marker(line, "// TASK ", id);
}

static int is_end(Line line, char id[HOLE_ID_BYTES])
{
    return is_marker(line, "// END ", id);
}

// A comment line right under the begin marker still belongs to the task's text.
static int is_comment(Line line)
{
    return after_prefix(line, "//") != NULL;
}

// A text that grows.
typedef struct Output {
    FILE *file;
    char *text;
    size_t n_bytes;
} Output;

static int output_open(Output *output)
{
    *output = (Output){0};
    output->file = open_memstream(&output->text, &output->n_bytes);
    return output->file != NULL;
}

static void output_line(Output *output, const char *start, size_t length)
{
    fwrite(start, 1, length, output->file);
    fputc('\n', output->file);
}

static char *output_close(Output *output)
{
    fclose(output->file);
    return output->text;
}

// Copy a placeholder line "    //> return 0;" as "    return 0;".
static void output_placeholder(Output *output, Line line)
{
    const char *code = after_prefix(line, "//>");
    const size_t indent = (size_t)(code - line.start) - strlen("//>");
    const char *end = line.start + line.length;
    if (code < end && *code == ' ') {
        code++;
    }
    if (code < end) {
        fwrite(line.start, 1, indent, output->file);
    }
    output_line(output, code, (size_t)(end - code));
}

// One line on stderr; closes the output. Returns NULL, for the caller to return.
static char *cut_failed(Output *output, const char *name, int number, const char *what)
{
    complain("%s:%d: %s", name, number, what);
    free(output_close(output));
    return NULL;
}

char *holes_cut(const char *solution, const char *name)
{
    Output output;
    if (!output_open(&output)) {
        complain("%s: no memory", name);
        return NULL;
    }
    char open_id[HOLE_ID_BYTES] = "", id[HOLE_ID_BYTES];
    int has_placeholder = 0, in_task_text = 0, number = 0;
    Line line;
    while (next_line(&solution, &line)) {
        number++;
        if (is_begin(line, id)) {
            if (open_id[0] != '\0') {
                return cut_failed(&output, name, number, "a TASK inside a task");
            }
            strcpy(open_id, id);
            has_placeholder = 0;
            in_task_text = 1;
            output_line(&output, line.start, line.length);
        } else if (is_end(line, id)) {
            if (strcmp(open_id, id) != 0) {
                return cut_failed(&output, name, number, "END without its TASK");
            }
            if (!has_placeholder) {
                return cut_failed(&output, name, number, "a task without a //> placeholder");
            }
            open_id[0] = '\0';
            output_line(&output, line.start, line.length);
        } else if (open_id[0] == '\0') {
            output_line(&output, line.start, line.length);
        } else if (after_prefix(line, "//>") != NULL) {
            output_placeholder(&output, line);
            has_placeholder = 1;
            in_task_text = 0;
        } else if (in_task_text && is_comment(line)) {
            output_line(&output, line.start, line.length);
        } else {
            in_task_text = 0;  // the solution itself is left out
        }
    }
    if (open_id[0] != '\0') {
        return cut_failed(&output, name, number, "a TASK without its END");
    }
    return output_close(&output);
}

int hole_id(const char *text, int index, char id[HOLE_ID_BYTES])
{
    Line line;
    while (next_line(&text, &line)) {
        if (is_begin(line, id) && index-- == 0) {
            return 1;
        }
    }
    return 0;
}

// Where the markers of a hole stand, and its content.
typedef struct Hole {
    int begin, end;  // the lines of the first of each, from 1; 0 when there is none
    int second;      // the first line that has one a second time, or 0
    int second_is_end;
    const char *start, *stop;  // the content, where each marker is there once, in order
} Hole;

static Hole markers_find(const char *text, const char *id)
{
    Hole hole = {0};
    char found[HOLE_ID_BYTES];
    int in_task_text = 0;
    Line line;
    for (int number = 1; next_line(&text, &line); number++) {
        const int ends = is_end(line, found);
        if ((ends || is_begin(line, found)) && strcmp(found, id) == 0) {
            int *first = ends ? &hole.end : &hole.begin;
            if (*first == 0) {
                *first = number;
            } else if (hole.second == 0) {
                hole.second = number;
                hole.second_is_end = ends;
            }
            *(ends ? &hole.stop : &hole.start) = ends ? line.start : text;
            in_task_text = !ends;
        } else if (in_task_text && is_comment(line) && after_prefix(line, "//>") == NULL) {
            hole.start = text;
        } else {
            in_task_text = 0;
        }
    }
    return hole;
}

// Returns whether the markers are there exactly once each, in order.
static int hole_find(const char *text, const char *id, Hole *hole)
{
    *hole = markers_find(text, id);
    return hole->begin > 0 && hole->end > 0 && hole->second == 0 && hole->start <= hole->stop;
}

char *hole_fault(const char *text, const char *id)
{
    const Hole at = markers_find(text, id);
    if (at.second != 0) {
        return message_new("line %d: \"// %s %s\" stands there a second time", at.second,
                           at.second_is_end ? "END" : "TASK", id);
    }
    if (at.begin == 0 && at.end == 0) {
        return message_new("the lines \"// TASK %s\" and \"// END %s\" are missing", id, id);
    }
    if (at.begin == 0) {
        return message_new("line %d: \"// END %s\", but no line \"// TASK %s\" before it", at.end,
                           id, id);
    }
    if (at.end == 0) {
        return message_new("line %d: \"// TASK %s\", but no line \"// END %s\" behind it", at.begin,
                           id, id);
    }
    return at.begin < at.end
               ? NULL
               : message_new("line %d: \"// END %s\" stands before \"// TASK %s\"", at.end, id, id);
}

char *hole_read(const char *text, const char *id)
{
    Hole hole;
    return hole_find(text, id, &hole) ? strndup(hole.start, (size_t)(hole.stop - hole.start))
                                      : NULL;
}

char *hole_load(const char *path, const char *id)
{
    char *text = text_file_read(path);
    char *content = text != NULL ? hole_read(text, id) : NULL;
    free(text);
    return content;
}

int hole_has_line(const char *text, const char *id, int number)
{
    Hole hole;
    Line line = {0};
    if (!hole_find(text, id, &hole)) {
        return 0;
    }
    while (number > 0 && next_line(&text, &line)) {
        number--;
    }
    return number == 0 && line.start >= hole.start && line.start < hole.stop;
}

char *hole_fill(const char *solution, const char *id, const char *body)
{
    Hole hole;
    Output output;
    if (!hole_find(solution, id, &hole) || !output_open(&output)) {
        return NULL;
    }
    fwrite(solution, 1, (size_t)(hole.start - solution), output.file);
    fputs(body, output.file);
    if (body[0] != '\0' && body[strlen(body) - 1] != '\n') {
        fputc('\n', output.file);
    }
    fputs(hole.stop, output.file);
    return output_close(&output);
}
