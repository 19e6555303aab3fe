// Figures of a run: collected, printed, written as JSON (see stats.h).
//
// What a run cost, for people and for the bench. Jansson keeps the figures in the order they were
// added. Read next: output_file.h.
#include "stats.h"

#include "clean_text.h"
#include "complain.h"
#include "output_file.h"
#include "standard_streams.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

// Takes over `value`, also when it is NULL because memory ran out.
static void figure_add(Stats *stats, const char *name, json_t *value)
{
    if (stats->values == NULL) {
        stats->values = json_object();
    }
    if (stats->values == NULL || json_object_set_new(stats->values, name, value) != 0) {
        complain("stats: no memory for \"%s\"", name);
        exit(EXIT_FAILURE);
    }
}

void stats_text(Stats *stats, const char *name, const char *value)
{
    json_t *string = json_string(value);
    if (string == NULL) {  // JSON is UTF-8, but a file's name may hold any bytes
        char *clean = text_clean(value, TEXT_QUOTED);
        string = json_string(clean);
        free(clean);
    }
    figure_add(stats, name, string);
}

void stats_integer(Stats *stats, const char *name, int64_t value)
{
    figure_add(stats, name, json_integer(value));
}

void stats_number(Stats *stats, const char *name, double value)
{
    figure_add(stats, name, isfinite(value) ? json_real(value) : json_null());
}

static int compare_numbers(const void *left, const void *right)
{
    double a = *(const double *)left;
    double b = *(const double *)right;
    return (a > b) - (a < b);
}

double stats_median(double *numbers, int n)
{
    qsort(numbers, (size_t)n, sizeof *numbers, compare_numbers);
    return (numbers[(n - 1) / 2] + numbers[n / 2]) / 2;
}

double *stats_times_create(int n)
{
    double *milliseconds = calloc((size_t)n, sizeof *milliseconds);
    if (milliseconds == NULL) {
        complain("stats: no memory for %d times", n);
        exit(EXIT_FAILURE);
    }
    return milliseconds;
}

void stats_milliseconds(Stats *stats, const char *name, double *milliseconds, int n)
{
    if (n < 1) {
        return;
    }
    double median = stats_median(milliseconds, n);

    char figure_name[128];
    snprintf(figure_name, sizeof figure_name, "%s.min_ms", name);
    stats_number(stats, figure_name, milliseconds[0]);
    snprintf(figure_name, sizeof figure_name, "%s.median_ms", name);
    stats_number(stats, figure_name, median);
    snprintf(figure_name, sizeof figure_name, "%s.max_ms", name);
    stats_number(stats, figure_name, milliseconds[n - 1]);
}

static void figure_print(const char *name, const json_t *value, int name_width)
{
    printf("%-*s  ", name_width, name);
    if (json_is_string(value)) {
        char *clean = line_clean(json_string_value(value));  // a file's name may be anything
        printf("%s\n", clean);
        free(clean);
    } else if (json_is_integer(value)) {
        printf("%" JSON_INTEGER_FORMAT "\n", json_integer_value(value));
    } else if (json_is_real(value)) {
        printf("%.6g\n", json_real_value(value));
    } else {
        printf("null\n");
    }
}

static void figures_print(const Stats *stats)
{
    const char *name;
    json_t *value;
    int name_width = 0;
    json_object_foreach(stats->values, name, value)
    {
        int length = (int)strlen(name);
        name_width = length > name_width ? length : name_width;
    }
    json_object_foreach(stats->values, name, value)
    {
        figure_print(name, value, name_width);
    }
}

static int figures_write(const Stats *stats, const char *path)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    // What fails in here marks the stream, and output_file_commit() reports it.
    if (stats->values == NULL) {
        fputs("{}", output.file);
    } else {
        json_dumpf(stats->values, output.file, JSON_INDENT(2));
    }
    fputc('\n', output.file);
    return output_file_commit(&output);
}

int stats_report(const Stats *stats, const char *path)
{
    if (stats->values != NULL) {
        figures_print(stats);
    }
    if (standard_output_check() != 0) {
        return -1;
    }
    return path == NULL ? 0 : figures_write(stats, path);
}

void stats_free(Stats *stats)
{
    json_decref(stats->values);
    stats->values = NULL;
}

double stats_clock_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}
