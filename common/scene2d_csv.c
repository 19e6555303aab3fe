// 2D scenes as CSV text (scene2d_read_csv() and scene2d_write_csv() of scene2d.h).
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison. A line is read, cut into fields by
// libcsv (which knows about quotes), and every field becomes a number of the circle. The first
// fault is reported with its line and ends the reading. Read next: number.h.
#include "number.h"
#include "scene2d.h"

#include <csv.h>
#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

// A scene needs some 80 characters a line. What is longer is no scene, or a quote never closed.
#define MAX_LINE 4096

// What a field may hold.
typedef enum FieldRange { ANY_FINITE, NOT_NEGATIVE, COLOUR } FieldRange;

static const struct Column {
    const char *name;
    size_t offset;  // of the number in a Circle
    FieldRange range;
} COLUMNS[] = {
    {"x", offsetof(Circle, x), ANY_FINITE},
    {"y", offsetof(Circle, y), ANY_FINITE},
    {"radius", offsetof(Circle, radius), NOT_NEGATIVE},
    {"depth", offsetof(Circle, depth), ANY_FINITE},
    {"r", offsetof(Circle, r), COLOUR},
    {"g", offsetof(Circle, g), COLOUR},
    {"b", offsetof(Circle, b), COLOUR},
    {"a", offsetof(Circle, a), COLOUR},
};
enum { N_COLUMNS = sizeof COLUMNS / sizeof COLUMNS[0], N_REQUIRED = N_COLUMNS - 1 };

typedef struct CsvReader {
    const char *name;                        // what messages call the file
    int line;                                // counts from 1
    int failed;                              // a message was printed
    const struct Column *header[N_COLUMNS];  // the file's columns, in its order
    int n_header;                            // 0 until the header was read
    int n_fields;                            // of the line being read
    Circle circle;                           // being read
    Circle *circles;
    int n_circles;
    int capacity;
} CsvReader;

// Complain about the current line: the only place that prints, so that one fault gives one message.
static void fault(CsvReader *reader, const char *where, const char *found, const char *expected)
{
    if (!reader->failed) {
        fprintf(stderr, "%s:%d: %sfound %s, expected %s\n", reader->name, reader->line, where,
                found, expected);
    }
    reader->failed = 1;
}

// Text from a file, fit for a message: in quotes, not too long, nothing that moves a terminal.
static const char *quote(const char *text, char *quoted, size_t size)
{
    snprintf(quoted, size, "\"%.40s%s\"", text, strlen(text) > 40 ? "..." : "");
    for (char *c = quoted; *c != '\0'; c++) {
        if ((unsigned char)*c < ' ' || (unsigned char)*c >= 0x7f) {
            *c = '?';
        }
    }
    return quoted;
}

static void header_field_read(CsvReader *reader, const char *text)
{
    char found[64];
    for (int i = 0; i < reader->n_fields; i++) {
        if (strcmp(reader->header[i]->name, text) == 0) {
            fault(reader, "", quote(text, found, sizeof found), "each column once");
            return;
        }
    }
    for (int i = 0; i < N_COLUMNS; i++) {
        if (strcmp(COLUMNS[i].name, text) == 0) {
            reader->header[reader->n_fields++] = &COLUMNS[i];
            return;
        }
    }
    fault(reader, "", quote(text, found, sizeof found),
          "the names of columns: x,y,radius,depth,r,g,b[,a]");
}

static void number_field_read(CsvReader *reader, const char *text)
{
    if (reader->n_fields == reader->n_header) {
        fault(reader, "", "more fields", "as many as the first line has");
        return;
    }
    const struct Column *column = reader->header[reader->n_fields++];
    const char *expected = NULL;
    float value = 0;
    if (number_read_float(text, &value) != 0) {
        expected = "a finite number";
    } else if (column->range == NOT_NEGATIVE && value < 0) {
        expected = "a number of at least 0";
    } else if (column->range == COLOUR && (value < 0 || value > 1)) {
        expected = "a number from 0 to 1";
    }
    if (expected != NULL) {
        char where[16], found[64];
        snprintf(where, sizeof where, "%s: ", column->name);
        fault(reader, where, quote(text, found, sizeof found), expected);
        return;
    }
    memcpy((char *)&reader->circle + column->offset, &value, sizeof value);
}

// libcsv calls this for every field of a line...
static void field_read(void *text, size_t length, void *context)
{
    (void)length;  // CSV_APPEND_NULL ends the text, and lines with other NUL bytes are refused
    CsvReader *reader = context;
    if (reader->failed) {
        return;
    }
    if (reader->n_header == 0) {
        header_field_read(reader, text);
    } else {
        number_field_read(reader, text);
    }
}

static void header_end(CsvReader *reader)
{
    for (int i = 0; i < N_REQUIRED; i++) {
        int present = 0;
        for (int j = 0; j < reader->n_fields; j++) {
            present |= reader->header[j] == &COLUMNS[i];
        }
        if (!present) {
            char found[32];
            snprintf(found, sizeof found, "no column \"%s\"", COLUMNS[i].name);
            fault(reader, "", found, "x,y,radius,depth,r,g,b[,a]");
            return;
        }
    }
    reader->n_header = reader->n_fields;
}

static void circle_end(CsvReader *reader)
{
    if (reader->n_fields < reader->n_header) {
        char found[32], expected[32];
        snprintf(found, sizeof found, "%d fields", reader->n_fields);
        snprintf(expected, sizeof expected, "%d", reader->n_header);
        fault(reader, "", found, expected);
        return;
    }
    if (reader->n_circles == SCENE2D_MAX_CIRCLES) {
        fault(reader, "", "more circles", "at most 10000000");
        return;
    }
    if (reader->n_circles == reader->capacity) {
        int capacity = reader->capacity == 0 ? 1024 : 2 * reader->capacity;
        Circle *circles = realloc(reader->circles, (size_t)capacity * sizeof *circles);
        if (circles == NULL) {
            fault(reader, "", "no memory", "a smaller scene");
            return;
        }
        reader->circles = circles;
        reader->capacity = capacity;
    }
    reader->circles[reader->n_circles++] = reader->circle;
}

// ... and this at the end of the line.
static void line_end(int terminator, void *context)
{
    (void)terminator;
    CsvReader *reader = context;
    if (!reader->failed && reader->n_header == 0) {
        header_end(reader);
    } else if (!reader->failed) {
        circle_end(reader);
    }
    reader->n_fields = 0;
    reader->circle = (Circle){.a = 1};
}

// Read a line without its end. Returns its length, -1 at the end of the file, -2 after a message.
static int line_read(CsvReader *reader, FILE *file, char *line)
{
    int length = 0;
    int c;
    reader->line++;
    while ((c = getc_unlocked(file)) != EOF && c != '\n') {
        if (c == '\0') {
            fault(reader, "", "a NUL byte", "text");
            return -2;
        }
        if (length == MAX_LINE) {
            fault(reader, "", "more than 4096 characters", "a shorter line");
            return -2;
        }
        line[length++] = (char)c;
    }
    if (c == EOF && ferror(file)) {
        fault(reader, "", strerror(errno), "a file that can be read");
        return -2;
    }
    return c == EOF && length == 0 ? -1 : length;
}

_Static_assert(MAX_LINE == 4096 && SCENE2D_MAX_CIRCLES == 10000000,
               "the messages above name these limits");

// Each line is a record of its own: a quote left open ends with its line, not with the file.
static void line_parse(CsvReader *reader, struct csv_parser *parser, const char *line, int length)
{
    if (length > 0 && line[0] == '#') {
        return;
    }
    size_t n_parsed = csv_parse(parser, line, (size_t)length, field_read, line_end, reader);
    if (n_parsed != (size_t)length || csv_fini(parser, field_read, line_end, reader) != 0) {
        int out_of_memory = csv_error(parser) == CSV_ENOMEM;
        fault(reader, "", out_of_memory ? "no memory" : "a quote in a wrong place",
              out_of_memory ? "a smaller scene" : "quotes around a whole field, or none");
    }
}

int scene2d_read_csv(FILE *file, const char *name, Scene2D *scene)
{
    CsvReader reader = {.name = name, .circle.a = 1};
    struct csv_parser parser;
    csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI | CSV_APPEND_NULL);

    char line[MAX_LINE];
    int length;
    while (!reader.failed && (length = line_read(&reader, file, line)) >= 0) {
        // Some editors mark a file as UTF-8 with these three bytes.
        int mark = reader.line == 1 && length >= 3 && memcmp(line, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
        line_parse(&reader, &parser, line + mark, length - mark);
    }
    csv_free(&parser);
    if (reader.n_header == 0) {
        fault(&reader, "", "the end of the file", "the columns x,y,radius,depth,r,g,b[,a]");
    }

    if (reader.failed) {
        free(reader.circles);
        return -1;
    }
    scene->circles = reader.circles;
    scene->n_circles = reader.n_circles;
    return 0;
}

int scene2d_write_csv(FILE *file, const Scene2D *scene)
{
    fprintf(file, "x,y,radius,depth,r,g,b,a\n");
    for (int i = 0; i < scene->n_circles; i++) {
        for (int column = 0; column < N_COLUMNS; column++) {
            float value;
            char text[NUMBER_TEXT_SIZE];
            memcpy(&value, (const char *)&scene->circles[i] + COLUMNS[column].offset, sizeof value);
            number_write_float(value, text);
            fprintf(file, column == 0 ? "%s" : ",%s", text);
        }
        fputc('\n', file);
    }
    return ferror(file) ? -1 : 0;
}
