// A table of options, which says how a program's command line is read, refused and explained.
//
// Each row has its place in a struct of the program's own:
//
//     typedef struct BenchOptions { const char *device; int n_rounds; int help; } BenchOptions;
//
//     static const OptionRow ROWS[] = {
//         {"device", "D", OPTION_TEXT, offsetof(BenchOptions, device), .meaning = "..."},
//         {"rounds", "N", OPTION_NUMBER, offsetof(BenchOptions, n_rounds), 1, 99, 0, "..."},
//         {"help", NULL, OPTION_ANSWER, offsetof(BenchOptions, help), .meaning = "show this"},
//     };
//
// The words are read by getopt_long(): "--rounds 7", "--rounds=7", "--ro 7".
// Read next: options.h, the labs' command line.
#ifndef COMMON_OPTION_TABLE_H
#define COMMON_OPTION_TABLE_H

#include <stddef.h>

// The `highest` of a number that has no limit worth telling: "expected ... of at least 1".
#define OPTION_LARGEST_NUMBER 1000000000

typedef enum OptionKind {
    OPTION_TEXT,    // const char *: as given, a word of argv
    OPTION_NUMBER,  // int: a whole number from lowest to highest
    OPTION_SIZE,    // two int, one after the other: "640x480", both from lowest to highest
    OPTION_POINT,   // the same with a comma: "200,120"
    OPTION_SEED,    // uint64_t: a whole number
    OPTION_FLAG,    // int: 1 where it is given; no argument
    OPTION_ANSWER,  // the same; the program answers it and ends: what follows is not read
} OptionKind;

typedef struct OptionRow {
    const char *name;      // without "--"
    const char *argument;  // what the help calls it; NULL where there is none
    OptionKind kind;
    size_t place;         // of its value, in bytes from the struct's beginning
    int lowest, highest;  // of a number, a side, a coordinate
    int set;              // for the program's own use, as in options.c
    const char *meaning;  // for the help; lines are separated by '\n'
} OptionRow;

// How many rows a table has at most.
#define OPTION_TABLE_MAX_ROWS 32

typedef struct OptionTable {
    const char *program;  // for the messages
    const OptionRow *rows;
    int n_rows;       // at most OPTION_TABLE_MAX_ROWS
    int takes_words;  // 1: words that are no options are left, in order, at argv[optind]
    // With --make as its first word the first so many rows are read from the environment, too,
    // where make has them: "time-limit" is TIME_LIMIT. An empty one is not given.
    int n_from_make;
} OptionTable;

typedef enum OptionsResult {
    OPTIONS_RUN,   // go on
    OPTIONS_DONE,  // an option that is an answer (--help): answer it and end with EXIT_SUCCESS
    OPTIONS_BAD,   // one message was printed: end with EXIT_FAILURE
} OptionsResult;

// Read a command line.
//   values    in/out: the program's struct, with what holds where an option is not given
//   is_given  out: for each row 1 where it is given, else 0; NULL: not wanted
OptionsResult option_table_read(const OptionTable *table, int argc, char **argv, void *values,
                                int *is_given);

// Complain about an argument: PROGRAM: --OPTION: found "FOUND", expected EXPECTED (try --help).
// Returns OPTIONS_BAD.
OptionsResult option_table_refuse(const OptionTable *table, const char *option, const char *found,
                                  const char *expected);

// Print a row of the help to stdout, without its line's end: "  --rounds N   how often ...".
void option_row_print(const OptionRow *row);

#endif
