// copies-term.html and copies-term.json: pairs over several labs (see copies_term.h).
#include "copies_term.h"
#include "html.h"
#include "json_text.h"
#include "output_file.h"
#include "side_by_side.h"

#include <math.h>

static const char *person_of(const AlikeTerm *all, const TermPair *pair, int is_second)
{
    return all->term.persons[is_second ? pair->labs->second : pair->labs->first].name;
}

// ---- The page --------------------------------------------------------------------------------

static void head_write(FILE *page, const AlikeTerm *all)
{
    fprintf(page,
            "<header>\n<h1>The term: answers that are alike</h1>\n<dl class=\"facts\">\n"
            "<div><dt>Labs</dt><dd>%d</dd></div>\n<div><dt>Persons</dt><dd>%d</dd></div>\n"
            "<div><dt>Pairs to look at</dt><dd>%d</dd></div>\n</dl>\n</header>\n",
            all->term.n_labs, all->term.n_persons, all->n_listed);
    side_by_side_reasons(page);
}

static void table_write(FILE *page, const AlikeTerm *all)
{
    fprintf(page,
            "<h2 class=\"section\" id=\"pairs\">Pairs</h2>\n<p class=\"soft\">The most alike "
            "first, %d at most. A score is the sum of the labs' scores; pairs are listed from "
            "%.1f on.</p>\n",
            PAIRS_LISTED, all->level);
    if (all->n_listed == 0) {
        fputs("<p class=\"soft\">No pair stands out.</p>\n", page);
        return;
    }
    fputs("<div class=\"card\"><table>\n<thead><tr><th>Pair</th><th>Person</th><th>Person</th>",
          page);
    for (int lab = 0; lab < all->term.n_labs; lab++) {
        html_write(page, "<th class=\"number\">%s</th>", all->term.labs[lab].lab);
    }
    fputs("<th class=\"number\">Score</th></tr></thead>\n<tbody>\n", page);
    for (int i = 0; i < all->n_listed; i++) {
        const TermPair *pair = &all->pairs[i];
        html_write(page,
                   "<tr><td class=\"number\"><a href=\"#pair-%d\">%d</a></td>"
                   "<td class=\"name\">%s</td><td class=\"name\">%s</td>",
                   i + 1, i + 1, person_of(all, pair, 0), person_of(all, pair, 1));
        for (int lab = 0, at = 0; lab < all->term.n_labs; lab++) {
            if (at < pair->n_labs && pair->labs[at].lab == lab) {
                fprintf(page, "<td class=\"number\">%.1f</td>", pair->labs[at++].pair->score);
            } else {
                fputs("<td class=\"number\">&ndash;</td>", page);
            }
        }
        fprintf(page, "<td class=\"number\"><b>%.1f</b></td></tr>\n", pair->score);
    }
    fputs("</tbody>\n</table></div>\n", page);
}

static void pair_write(FILE *page, const AlikeTerm *all, int i)
{
    const TermPair *pair = &all->pairs[i];
    html_write(page, "<h2 class=\"section\" id=\"pair-%d\">%d. %s and %s</h2>\n", i + 1, i + 1,
               person_of(all, pair, 0), person_of(all, pair, 1));
    for (int at = 0; at < pair->n_labs; at++) {
        html_write(page, "<div class=\"card\">\n<div class=\"title\"><b>%s: ",
                   all->term.labs[pair->labs[at].lab].lab);
        side_by_side_write(page, &all->labs[pair->labs[at].lab], pair->labs[at].pair);
        fputs("</div>\n", page);
    }
}

int copies_term_page(const AlikeTerm *all, const char *path)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    html_page_begin(output.file, "The term: answers that are alike");
    head_write(output.file, all);
    table_write(output.file, all);
    if (all->n_listed > 0) {
        side_by_side_begin(output.file);
    }
    for (int i = 0; i < all->n_listed; i++) {
        pair_write(output.file, all, i);
    }
    html_page_end(output.file);
    return output_file_commit(&output);
}

// ---- For programs ----------------------------------------------------------------------------

int copies_term_json(const AlikeTerm *all, const char *path)
{
    json_t *list = json_array();
    for (int i = 0; i < all->n_listed; i++) {
        const TermPair *pair = &all->pairs[i];
        json_t *labs = json_object();
        for (int at = 0; at < pair->n_labs; at++) {
            json_object_set_new(labs, all->term.labs[pair->labs[at].lab].lab,
                                json_real(round(100 * pair->labs[at].pair->score) / 100));
        }
        json_array_append_new(list, json_pack("{s:[o, o], s:f, s:o}", "persons",
                                              json_line(person_of(all, pair, 0)),
                                              json_line(person_of(all, pair, 1)), "score",
                                              round(100 * pair->score) / 100, "labs", labs));
    }
    return json_save(path,
                     json_pack("{s:i, s:i, s:f, s:o}", "labs", all->term.n_labs, "persons",
                               all->term.n_persons, "level", round(100 * all->level) / 100, "pairs",
                               list),
                     JSON_INDENT(1));
}
