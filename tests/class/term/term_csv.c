// term.csv: a row for each student, a column for each lab (see term.h).
//
// No cell is a formula (csv_cell.h). A score that is missing is a blank, and no zero. Read next:
// term_page.c.
#include "term.h"

#include "csv_cell.h"
#include "output_file.h"

#include <stdlib.h>
#include <string.h>

char *term_note(const Term *term, const Person *person)
{
    const char *between = "";
    char *note = NULL;
    size_t size;
    FILE *file = open_memstream(&note, &size);
    if (file == NULL) {
        return NULL;
    }
    if (person->note != NULL) {
        fputs(person->note, file);
        between = "; ";
    }
    for (int i = 0; i < term->n_labs; i++) {
        const Entry *entry = person->entries[i];
        if (entry != NULL && entry->open != NULL) {
            fprintf(file, "%s%s %s", between, term->labs[i].lab, entry->open);
            between = "; ";
        }
    }
    fclose(file);
    return note;
}

static void cell_write(FILE *file, char between, const char *text)
{
    fputc(between, file);
    csv_cell_write(file, text);
}

static void head_write(FILE *file, const Term *term, char between)
{
    csv_cell_write(file, "name");
    cell_write(file, between, "address");
    cell_write(file, between, "number");
    for (int i = 0; i < term->n_labs; i++) {
        cell_write(file, between, term->labs[i].lab);
    }
    cell_write(file, between, "sum");
    cell_write(file, between, "max");
    cell_write(file, between, "passed");
    if (term->need > 0) {
        cell_write(file, between, "admitted");
    }
    cell_write(file, between, "note");
    fputc('\n', file);
}

static void row_write(FILE *file, const Term *term, const Person *person, char between)
{
    csv_cell_write(file, person->name);
    cell_write(file, between, person->address);
    cell_write(file, between, person->id_number);
    for (int i = 0; i < term->n_labs; i++) {
        const Entry *entry = person->entries[i];
        fputc(between, file);
        if (entry != NULL && entry->has_score) {
            fprintf(file, "%d", entry->score);
        }
    }
    fprintf(file, "%c%d%c%d%c%d", between, person->sum, between, term->max_sum, between,
            person->n_passed);
    if (term->need > 0) {
        cell_write(file, between, term_admission(term, person));
    }
    char *note = term_note(term, person);
    cell_write(file, between, note != NULL ? note : "");
    free(note);
    fputc('\n', file);
}

int term_csv(const Term *term, const char *path, int is_for_excel)
{
    const char between = is_for_excel ? ';' : ',';
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fputs(is_for_excel ? "\xEF\xBB\xBF" : "", output.file);
    head_write(output.file, term, between);
    for (int i = 0; i < term->n_persons; i++) {
        row_write(output.file, term, &term->persons[i], between);
    }
    return output_file_commit(&output);
}
