// Reading a command line by a table of options (see option_table.h).
//
// Read next: options.c, which has the labs' table.
#include "option_table.h"

#include "complain.h"
#include "number.h"

#include <ctype.h>
#include <getopt.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// What getopt_long() returns for the first row of the table: beyond every letter, as those stand
// for faults.
#define FIRST_ROW 256

// The column at which the help's meanings begin.
#define MEANING_COLUMN 22

OptionsResult option_table_refuse(const OptionTable *table, const char *option, const char *found,
                                  const char *expected)
{
    complain("%s: --%s: found \"%s\", expected %s (try --help)", table->program, option, found,
             expected);
    return OPTIONS_BAD;
}

void option_row_print(const OptionRow *row)
{
    char option[64];
    snprintf(option, sizeof option, "--%s %s", row->name, row->argument ? row->argument : "");
    printf("  %-*s", MEANING_COLUMN - 2, option);
    for (const char *line = row->meaning; *line != '\0';) {
        const int length = (int)strcspn(line, "\n");
        printf("%.*s", length, line);
        line += length;
        if (*line == '\n') {
            printf("\n%*s", MEANING_COLUMN, "");
            line++;
        }
    }
}

// Returns 0, or -1.
static int read_number(const OptionRow *row, const char *text, int *value)
{
    int64_t number;
    if (number_read_integer(text, row->lowest, row->highest, &number) != 0) {
        return -1;
    }
    *value = (int)number;
    return 0;
}

// "640x480" or "200,120": two numbers and what is between them.
//   value   out: two int, one after the other
// Returns 0, or -1 and leaves *value alone.
static int read_pair(const OptionRow *row, const char *text, char between, void *value)
{
    char first[16];
    const char *end = strchr(text, between);
    if (end == NULL || (size_t)(end - text) >= sizeof first) {
        return -1;
    }
    memcpy(first, text, (size_t)(end - text));
    first[end - text] = '\0';

    int numbers[2];
    if (read_number(row, first, &numbers[0]) != 0 || read_number(row, end + 1, &numbers[1]) != 0) {
        return -1;
    }
    memcpy(value, numbers, sizeof numbers);
    return 0;
}

// Complain about an argument that is no number, or no two. Returns OPTIONS_BAD.
static OptionsResult refuse_number(const OptionTable *table, const OptionRow *row,
                                   const char *found)
{
    char expected[80];
    if (row->kind == OPTION_SEED) {
        snprintf(expected, sizeof expected, "a whole number from 0 to %ju", (uintmax_t)UINT64_MAX);
    } else if (row->kind == OPTION_POINT) {
        snprintf(expected, sizeof expected, "X,Y, two whole numbers from %d to %d", row->lowest,
                 row->highest);
    } else if (row->kind == OPTION_SIZE) {
        snprintf(expected, sizeof expected, "WxH, two whole numbers from %d to %d", row->lowest,
                 row->highest);
    } else if (row->highest == OPTION_LARGEST_NUMBER) {
        snprintf(expected, sizeof expected, "a whole number of at least %d", row->lowest);
    } else {
        snprintf(expected, sizeof expected, "a whole number from %d to %d", row->lowest,
                 row->highest);
    }
    return option_table_refuse(table, row->name, found, expected);
}

// Take one option in; `text` is its argument.
static OptionsResult read_option(const OptionTable *table, const OptionRow *row, const char *text,
                                 void *values)
{
    void *value = (char *)values + row->place;
    int failed = 0;
    switch (row->kind) {
    case OPTION_TEXT:
        *(const char **)value = text;
        break;
    case OPTION_NUMBER:
        failed = read_number(row, text, value);
        break;
    case OPTION_SIZE:
        failed = read_pair(row, text, 'x', value);
        break;
    case OPTION_POINT:
        failed = read_pair(row, text, ',', value);
        break;
    case OPTION_SEED:
        failed = number_read_unsigned(text, 0, UINT64_MAX, value);
        break;
    case OPTION_FLAG:
        *(int *)value = 1;
        break;
    case OPTION_ANSWER:
        *(int *)value = 1;
        return OPTIONS_DONE;
    }
    return failed ? refuse_number(table, row, text) : OPTIONS_RUN;
}

// How many options begin with the word "--s" or "--s=1"?
static int count_meant(const OptionTable *table, const char *word)
{
    int n_meant = 0;
    for (int i = 0; i < table->n_rows; i++) {
        n_meant += strncmp(table->rows[i].name, word + 2, strcspn(word + 2, "=")) == 0;
    }
    return n_meant;
}

// What getopt_long() could not take.
//   fault   its answer: ':' for an argument that is missing, '?' for all else
//   about   its optopt: FIRST_ROW or more is an option that exists, 0 a word with --, else a letter
static OptionsResult report_fault(const OptionTable *table, int fault, int about, const char *word)
{
    if (about >= FIRST_ROW) {
        complain("%s: --%s %s an argument (try --help)", table->program,
                 table->rows[about - FIRST_ROW].name, fault == ':' ? "needs" : "does not take");
    } else if (about != 0) {
        complain("%s: -%c is no option here (try --help)", table->program, about);
    } else {
        complain("%s: %s is %s (try --help)", table->program, word,
                 count_meant(table, word) > 1 ? "short for more than one option"
                                              : "no option here");
    }
    return OPTIONS_BAD;
}

// Take in a row's variable, if make has it.
static OptionsResult read_from_make(const OptionTable *table, const OptionRow *row, void *values)
{
    char name[64];
    size_t n = 0;
    for (; n < sizeof name - 1 && row->name[n] != '\0'; n++) {
        name[n] = row->name[n] == '-' ? '_' : (char)toupper((unsigned char)row->name[n]);
    }
    name[n] = '\0';
    const char *text = getenv(name);
    return text != NULL && text[0] != '\0' ? read_option(table, row, text, values) : OPTIONS_RUN;
}

OptionsResult option_table_read(const OptionTable *table, int argc, char **argv, void *values,
                                int *is_given)
{
    struct option known[OPTION_TABLE_MAX_ROWS + 1] = {0};
    for (int i = 0; i < table->n_rows; i++) {
        const int has_argument = table->rows[i].argument ? required_argument : no_argument;
        known[i] = (struct option){table->rows[i].name, has_argument, NULL, FIRST_ROW + i};
        if (is_given != NULL) {
            is_given[i] = 0;
        }
    }

    optind = 0;  // start afresh, for callers that read more than one command line
    if (argc > 1 && table->n_from_make > 0 && strcmp(argv[1], "--make") == 0) {
        for (int i = 0; i < table->n_from_make; i++) {
            if (read_from_make(table, &table->rows[i], values) != OPTIONS_RUN) {
                return OPTIONS_BAD;
            }
        }
        optind = 2;
    }
    int answer;
    // ":" asks for silence on faults and for ':' where an argument is missing.
    while ((answer = getopt_long(argc, argv, ":", known, NULL)) != -1) {
        if (answer < FIRST_ROW) {
            return report_fault(table, answer, optopt, argv[optind - 1]);
        }
        const int row = answer - FIRST_ROW;
        const OptionsResult result = read_option(table, &table->rows[row], optarg, values);
        if (result != OPTIONS_RUN) {
            return result;
        }
        if (is_given != NULL) {
            is_given[row] = 1;
        }
    }
    if (optind < argc && !table->takes_words) {
        complain("%s: found the stray word \"%s\" (try --help)", table->program, argv[optind]);
        return OPTIONS_BAD;
    }
    return OPTIONS_RUN;
}
