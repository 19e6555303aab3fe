// Filling a list of participants (see upload_csv.h).
//
// Lines and columns keep their order, and cells their text, but what a spreadsheet would take for a
// formula. Canvas knows a student again by the ID,
// Moodle by the identifier, Blackboard and Brightspace by the user name.
#include "upload_csv.h"

#include "list_cell.h"
#include "output_file.h"

// A list of somebody's own comes back in the form in which it came; a system takes plain CSV.
static SheetForm form_of(const Worksheet *worksheet)
{
    return worksheet->system == LIST_OTHER ? worksheet->form : (SheetForm){.delimiter = ','};
}

int upload_csv(const Gradebook *gradebook, const char *path, const Worksheet *worksheet)
{
    OutputFile output;
    if (worksheet->grade_column < 0) {
        return 0;
    }
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    const SheetForm form = form_of(worksheet);
    const char *line_end = form.has_dos_lines ? "\r\n" : "\n";
    const char delimiter[] = {form.delimiter, '\0'};
    fputs(form.has_mark ? "\xEF\xBB\xBF" : "", output.file);
    if (form.has_sep) {
        fprintf(output.file, "sep=%s%s", delimiter, line_end);
    }
    for (int i = 0; i < worksheet->n_participants; i++) {
        const char *mark = "";
        for (int column = 0; column < worksheet->n_columns; column++) {
            if (worksheet->is_uploaded[column]) {
                fputs(mark, output.file);
                list_cell_write(output.file, worksheet, &worksheet->participants[i], column,
                                gradebook);
                mark = delimiter;
            }
        }
        fputs(line_end, output.file);
    }
    return output_file_commit(&output);
}
