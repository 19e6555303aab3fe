// term.html: the table of a term as a page (see term.h). Read next: term.html, the template.
#include "html.h"
#include "output_file.h"
#include "template.h"
#include "term.h"

#include <stdlib.h>

TEMPLATE(term_html, "tests/class/term/term.html");

static json_t *lab_of(const Term *term, int i)
{
    const TermCount count = term_count(term, i);
    char mean[32];
    snprintf(mean, sizeof mean, "%.1f", count.mean);
    return json_pack("{s:s, s:i, s:i, s:i, s:s}", "lab", term->labs[i].lab, "most",
                     term->labs[i].max_score, "n_passed", count.n_passed, "n_scores",
                     count.n_scores, "mean", mean);
}

static json_t *person_of(const Term *term, const Person *person)
{
    json_t *scores = json_array();
    for (int i = 0; i < term->n_labs; i++) {
        const Entry *entry = person->entries[i];
        const int has_score = entry != NULL && entry->has_score;
        json_array_append_new(scores, json_pack("{s:b, s:i, s:b}", "has_score", has_score, "score",
                                                has_score ? entry->score : 0, "is_short",
                                                has_score && entry->score < term->pass));
    }
    char *note = term_note(term, person);
    json_t *json = json_pack(
        "{s:o, s:o, s:o, s:i, s:i, s:o, s:i, s:s, s:o}", "name", template_line(person->name),
        "contact", template_line(person->address[0] != '\0' ? person->address : person->id_number),
        "scores", scores, "sum", person->sum, "max_sum", term->max_sum, "bar",
        template_bar(person->sum, term->max_sum), "n_passed", person->n_passed, "admission",
        term_admission(term, person), "note", template_line(note));
    free(note);
    return json;
}

int term_page(const Term *term, const char *path)
{
    OutputFile output;
    json_t *labs = json_array(), *persons = json_array();
    for (int i = 0; i < term->n_labs; i++) {
        json_array_append_new(labs, lab_of(term, i));
    }
    for (int i = 0; i < term->n_persons; i++) {
        json_array_append_new(persons, person_of(term, &term->persons[i]));
    }
    json_t *page =
        json_pack("{s:i, s:o*, s:i, s:i, s:o, s:o}", "pass", term->pass, "need",
                  term->need > 0 ? json_integer(term->need) : NULL, "n_labs", term->n_labs,
                  "n_persons", term->n_persons, "labs", labs, "persons", persons);
    if (output_file_open(&output, path) != 0) {
        json_decref(page);
        return -1;
    }
    html_page_begin(output.file, "The term");
    const int failed = template_write(output.file, term_html, page);
    html_page_end(output.file);
    return template_commit(&output, failed);
}
