// term.html: the table of a term as a page (see term.h). Read next: html.h.
#include "html.h"
#include "output_file.h"
#include "term.h"

#include <stdlib.h>
#include <string.h>

static void head_write(FILE *page, const Term *term)
{
    fprintf(page, "<header>\n<h1>The term</h1>\n<p>A lab is passed from %d points on%s", term->pass,
            term->need > 0 ? "; " : "");
    if (term->need > 0) {
        fprintf(page, "an admission needs %d of %d labs", term->need, term->n_labs);
    }
    fputs(".</p>\n<dl class=\"facts\">\n", page);
    fprintf(page, "<div><dt>Rows</dt><dd>%d</dd></div>\n", term->n_persons);
    for (int i = 0; i < term->n_labs; i++) {
        const TermCount count = term_count(term, i);
        fputs("<div><dt>", page);
        html_line(page, term->labs[i].lab);
        fprintf(page, "</dt><dd>%d of %d passed, mean %.1f</dd></div>\n", count.n_passed,
                count.n_scores, count.mean);
    }
    fputs("</dl>\n</header>\n", page);
}

static void titles_write(FILE *page, const Term *term)
{
    fputs("<thead><tr><th>Student</th>", page);
    for (int i = 0; i < term->n_labs; i++) {
        fputs("<th class=\"number\">", page);
        html_line(page, term->labs[i].lab);
        fprintf(page, "<br>of %d</th>", term->labs[i].max_score);
    }
    fputs("<th class=\"number\">Sum</th><th class=\"number\">Passed</th>", page);
    fputs(term->need > 0 ? "<th>Admitted</th>" : "", page);
    fputs("<th>Note</th></tr></thead>\n", page);
}

static void note_write(FILE *page, const Term *term, const Person *person)
{
    char *note = term_note(term, person);
    fputs("<td class=\"first\">", page);
    html_line(page, note != NULL ? note : "");
    fputs("</td>", page);
    free(note);
}

static void row_write(FILE *page, const Term *term, const Person *person)
{
    fputs("<tr><td class=\"name\">", page);
    html_line(page, person->name);
    fputs(" <span class=\"soft\">", page);
    html_line(page, person->address[0] != '\0' ? person->address : person->id_number);
    fputs("</span></td>", page);
    for (int i = 0; i < term->n_labs; i++) {
        const Entry *entry = person->entries[i];
        if (entry != NULL && entry->has_score) {
            fprintf(page, "<td class=\"number%s\">%d</td>",
                    entry->score < term->pass ? " short" : "", entry->score);
        } else {
            fputs("<td class=\"number\">&ndash;</td>", page);
        }
    }
    fprintf(page, "<td class=\"number\"><b>%d</b> / %d", person->sum, term->max_sum);
    html_score_bar(page, person->sum, term->max_sum);
    fprintf(page, "</td><td class=\"number\">%d</td>", person->n_passed);
    if (term->need > 0) {
        fprintf(page, "<td>%s</td>", term_admission(term, person));
    }
    note_write(page, term, person);
    fputs("</tr>\n", page);
}

int term_page(const Term *term, const char *path)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    html_page_begin(output.file, "The term");
    head_write(output.file, term);
    fputs("<div class=\"card\"><table>\n", output.file);
    titles_write(output.file, term);
    fputs("<tbody>\n", output.file);
    for (int i = 0; i < term->n_persons; i++) {
        row_write(output.file, term, &term->persons[i]);
    }
    fputs("</tbody>\n</table></div>\n", output.file);
    html_page_end(output.file);
    return output_file_commit(&output);
}
