// A CSV file that a bench has written, for the tests of its reports.
#ifndef UNIT_CSV_FILE_H
#define UNIT_CSV_FILE_H

#include <criterion/criterion.h>
#include <stdio.h>
#include <string.h>

enum { CSV_TEXT_BYTES = 4096 };

// Read a file, each of whose rows has n_columns.
//   text   receives the rows as they are, the head first; they must fit
// Returns how many rows there are besides the head.
static inline int csv_file_read(const char *name, int n_columns, char text[CSV_TEXT_BYTES])
{
    char line[512];
    FILE *file = fopen(name, "r");
    cr_assert_not_null(file, "%s", name);
    text[0] = '\0';
    int n_rows = -1;  // the head is none
    for (; fgets(line, sizeof line, file) != NULL; n_rows++) {
        int n_commas = 0;
        for (const char *c = line; *c != '\0'; c++) {
            n_commas += *c == ',';
        }
        cr_expect_eq(n_commas, n_columns - 1, "%s", line);
        cr_assert_lt(strlen(text) + strlen(line), CSV_TEXT_BYTES, "%s", name);
        strcat(text, line);
    }
    fclose(file);
    return n_rows;
}

#endif
