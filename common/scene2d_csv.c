// 2D scenes as CSV text (scene2d_read_csv() of scene2d.h).
//
// A line is read, cut into fields by libcsv (which knows about quotes), and every field becomes a
// number of the circle. The first fault is reported with its line and ends the reading. Read next:
// line_reader.h.
#include "line_reader.h"
#include "number.h"
#include "scene2d.h"

#include <csv.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define LARGEST NUMBER_TEXT(SCENE2D_LARGEST)

// What a field may hold.
typedef enum FieldRange { ANY_FINITE, PLACE, RADIUS, COLOUR } FieldRange;

static const struct Column {
    const char *name;
    size_t offset;  // of the number in a Circle
    FieldRange range;
} COLUMNS[] = {
    {"x", offsetof(Circle, x), PLACE},
    {"y", offsetof(Circle, y), PLACE},
    {"radius", offsetof(Circle, radius), RADIUS},
    {"depth", offsetof(Circle, depth), ANY_FINITE},
    {"r", offsetof(Circle, r), COLOUR},
    {"g", offsetof(Circle, g), COLOUR},
    {"b", offsetof(Circle, b), COLOUR},
    {"a", offsetof(Circle, a), COLOUR},
};
enum { N_COLUMNS = sizeof COLUMNS / sizeof COLUMNS[0], N_REQUIRED = N_COLUMNS - 1 };

typedef struct CsvReader {
    LineReader lines;
    const struct Column *header[N_COLUMNS];  // the file's columns, in its order
    int n_header;                            // 0 until the header was read
    int n_fields;                            // of the line being read
    Circle circle;                           // being read
    Circle *circles;
    int n_circles;
    int capacity;
} CsvReader;

static void header_field_read(CsvReader *reader, const char *text)
{
    char found[LINE_QUOTE_SIZE];
    for (int i = 0; i < reader->n_fields; i++) {
        if (strcmp(reader->header[i]->name, text) == 0) {
            line_fault(&reader->lines, "", line_quote(text, found), "each column once");
            return;
        }
    }
    for (int i = 0; i < N_COLUMNS; i++) {
        if (strcmp(COLUMNS[i].name, text) == 0) {
            reader->header[reader->n_fields++] = &COLUMNS[i];
            return;
        }
    }
    line_fault(&reader->lines, "", line_quote(text, found),
               "the names of columns: x,y,radius,depth,r,g,b[,a]");
}

static void number_field_read(CsvReader *reader, const char *text)
{
    if (reader->n_fields == reader->n_header) {
        line_fault(&reader->lines, "", "more fields", "as many as the first line has");
        return;
    }
    const struct Column *column = reader->header[reader->n_fields++];
    const char *expected = NULL;
    float value = 0;
    if (number_read_float(text, &value) != 0) {
        expected = "a finite number";
    } else if (column->range == PLACE && fabsf(value) > (float)SCENE2D_LARGEST) {
        expected = "a number from -" LARGEST " to " LARGEST;
    } else if (column->range == RADIUS && (value < 0 || value > (float)SCENE2D_LARGEST)) {
        expected = "a number from 0 to " LARGEST;
    } else if (column->range == COLOUR && (value < 0 || value > 1)) {
        expected = "a number from 0 to 1";
    }
    if (expected != NULL) {
        char where[16], found[LINE_QUOTE_SIZE];
        snprintf(where, sizeof where, "%s: ", column->name);
        line_fault(&reader->lines, where, line_quote(text, found), expected);
        return;
    }
    memcpy((char *)&reader->circle + column->offset, &value, sizeof value);
}

// libcsv calls this for every field of a line...
static void field_read(void *text, size_t length, void *context)
{
    (void)length;  // CSV_APPEND_NULL ends the text, and lines with other NUL bytes are refused
    CsvReader *reader = context;
    if (reader->lines.failed) {
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
            line_fault(&reader->lines, "", found, "x,y,radius,depth,r,g,b[,a]");
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
        line_fault(&reader->lines, "", found, expected);
        return;
    }
    if (reader->n_circles == SCENE2D_MAX_CIRCLES) {
        line_fault(&reader->lines, "", "more circles", "at most " NUMBER_TEXT(SCENE2D_MAX_CIRCLES));
        return;
    }
    if (reader->n_circles == reader->capacity) {
        int capacity = reader->capacity == 0 ? 1024 : 2 * reader->capacity;
        Circle *circles = realloc(reader->circles, (size_t)capacity * sizeof *circles);
        if (circles == NULL) {
            line_fault(&reader->lines, "", "no memory", "a smaller scene");
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
    if (!reader->lines.failed && reader->n_header == 0) {
        header_end(reader);
    } else if (!reader->lines.failed) {
        circle_end(reader);
    }
    reader->n_fields = 0;
    reader->circle = (Circle){.a = 1};
}

// Each line is a record of its own: a quote left open ends with its line, not with the file.
static void line_parse(CsvReader *reader, struct csv_parser *parser)
{
    const char *line = reader->lines.text;
    const size_t length = strlen(line);
    if (line[0] == '#') {
        return;
    }
    size_t n_parsed = csv_parse(parser, line, length, field_read, line_end, reader);
    if (n_parsed != length || csv_fini(parser, field_read, line_end, reader) != 0) {
        int out_of_memory = csv_error(parser) == CSV_ENOMEM;
        line_fault(&reader->lines, "", out_of_memory ? "no memory" : "a quote in a wrong place",
                   out_of_memory ? "a smaller scene" : "quotes around a whole field, or none");
    }
}

int scene2d_read_csv(FILE *file, const char *name, Scene2D *scene)
{
    CsvReader reader = {.circle.a = 1};
    struct csv_parser parser;
    csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI | CSV_APPEND_NULL);

    line_reader_begin(&reader.lines, file, name);
    while (!reader.lines.failed && line_read(&reader.lines)) {
        line_parse(&reader, &parser);
    }
    csv_free(&parser);
    if (reader.n_header == 0) {
        line_fault(&reader.lines, "", "the end of the file",
                   "the columns x,y,radius,depth,r,g,b[,a]");
    }

    if (reader.lines.failed) {
        free(reader.circles);
        return -1;
    }
    line_warn(&reader.lines, "");
    scene->circles = reader.circles;
    scene->n_circles = reader.n_circles;
    return 0;
}
