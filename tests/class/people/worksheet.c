// Columns and grades of a list of participants (see worksheet.h). Read next: worksheet_load.c.
#include "worksheet.h"

#include "sheet.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

// ---- Columns ---------------------------------------------------------------------------------

int worksheet_has_title(const Worksheet *worksheet, int column, const char *const *titles)
{
    const char *title = worksheet->participants[0].cells[column];
    while (*titles != NULL && strcasecmp(title, *titles) != 0) {
        titles++;
    }
    return *titles != NULL;
}

int worksheet_column(const Worksheet *worksheet, const char *const *titles)
{
    for (int i = 0; i < worksheet->n_columns; i++) {
        if (worksheet_has_title(worksheet, i, titles)) {
            return i;
        }
    }
    return -1;
}

// ---- Grades ----------------------------------------------------------------------------------

int worksheet_maximum(const Worksheet *worksheet, const Participant *participant, int max_score,
                      double *most, char *decimal)
{
    const int column = worksheet->maximum_column;
    const char *cell = column >= 0 ? participant->cells[column] : worksheet->maximum;
    *most = max_score;
    *decimal = '.';
    return *cell == '\0' ? 0 : sheet_number_read(cell, most, decimal);
}

void worksheet_free(Worksheet *worksheet)
{
    for (int i = 0; i < worksheet->n_participants; i++) {
        for (int c = 0; c < SHEET_MAX_COLUMNS; c++) {
            free(worksheet->participants[i].cells[c]);
        }
    }
    free(worksheet->participants);
    for (int i = 0; i < worksheet->n_rows; i++) {
        free(worksheet->entered[i].why_not);
    }
    free(worksheet->entered);
    *worksheet = (Worksheet){0};
}

void worksheet_grade(const Worksheet *worksheet, const Participant *participant, int max_score,
                     char grade[32])
{
    double most;
    char decimal;
    worksheet_maximum(worksheet, participant, max_score, &most, &decimal);
    snprintf(grade, 32, "%.2f", participant->row->score * most / max_score);
    char *point = strchr(grade, '.');
    if (point != NULL) {
        *point = decimal;
    }
}
