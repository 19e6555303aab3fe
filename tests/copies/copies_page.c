// copies.html: pairs of answers side by side (see alike.h).
//
// It asks the instructor to look, and never says that somebody copied. Read next: side_by_side.h.
#include "alike.h"

#include "hard.h"
#include "html.h"
#include "output_file.h"
#include "side_by_side.h"

// ---- The head --------------------------------------------------------------------------------

// What an empty list would mean.
static void reach_write(FILE *page, const Alike *alike)
{
    const Pairs *pairs = &alike->pairs;
    const int n = alike->class.n_authors;
    fputs("<p class=\"message\">", page);
    if (n < PAIRS_MIN_AUTHORS) {
        fprintf(page,
                "Found %d authors, expected %d or more: among so few nobody can say what is rare.",
                n, PAIRS_MIN_AUTHORS);
    } else if (pairs_are_too_few(&alike->class, pairs)) {
        fprintf(page,
                "<b>These answers are too short to tell.</b> Only %d of %d authors wrote enough "
                "that few others wrote. The page says nothing about the others: two of them may "
                "have the same text and are not listed.",
                pairs->n_tellable, n);
    } else {
        fprintf(page,
                "%d of %d authors wrote enough that few others wrote: a second submission with "
                "the same text would be listed.",
                pairs->n_tellable, n);
        if (pairs->n_tellable < n) {
            fprintf(page, " About the other %d the page says nothing.", n - pairs->n_tellable);
        }
    }
    fputs("</p>\n", page);
}

static void head_write(FILE *page, const Alike *alike)
{
    const HandedIn *class = &alike->class;
    html_write(page,
               "<header>\n<p class=\"lab\">%s</p>\n<h1>%s: answers that are alike</h1>\n"
               "<dl class=\"facts\">\n<div><dt>Authors</dt><dd>%d</dd></div>\n"
               "<div><dt>Without an answer</dt><dd>%d</dd></div>\n"
               "<div><dt>Cannot be read</dt><dd>%d</dd></div>\n"
               "<div><dt>Pairs compared</dt><dd>%d</dd></div>\n"
               "<div><dt>Pairs to look at</dt><dd>%d</dd></div>\n</dl>\n",
               class->manifest.lab, class->manifest.title, class->n_authors, class->n_without,
               class->n_unread, alike->pairs.n_compared, alike->pairs.n_listed);
    reach_write(page, alike);
    fputs("</header>\n", page);
    side_by_side_reasons(page);
}

// ---- The table -------------------------------------------------------------------------------

static void row_write(FILE *page, const Alike *alike, int i)
{
    const Pair *pair = &alike->pairs.all[i];
    const Author *authors = alike->class.authors;
    html_write(page,
               "<tr><td class=\"number\"><a href=\"#pair-%d\">%d</a></td>"
               "<td class=\"name\">%s</td><td class=\"name\">%s</td>"
               "<td class=\"number\">%d</td><td class=\"number\">%d</td>",
               i + 1, i + 1, authors[pair->first].entrant->label,
               authors[pair->second].entrant->label, pair->n_only_two, pair->n_shared);
    fprintf(page,
            "<td class=\"number\">%.0f%%</td><td class=\"number\">%.1f"
            "<div class=\"bar speed\"><div style=\"width: %.1f%%\"></div></div></td></tr>\n",
            100 * pair->share, pair->score, 100 * pair->score / alike->pairs.all[0].score);
}

static void table_write(FILE *page, const Alike *alike)
{
    const Pairs *pairs = &alike->pairs;
    fputs("<h2 class=\"section\" id=\"pairs\">Pairs</h2>\n", page);
    if (pairs->n_listed == 0) {
        fputs("<p class=\"soft\">No pair stands out.</p>\n", page);
        return;
    }
    fprintf(page,
            "<p class=\"soft\">The most alike first, %d at most. A form is a statement without "
            "its names, its order and its spelling, or a comment, a name, or odd blanks. What "
            "the course gives does not count. A form weighs the more, the fewer of the class "
            "have it. The score is the weight of what both have, times its share; pairs are "
            "listed from %.1f on, which grows with the class. A pair is left out if better ones "
            "connect its authors already: three with one text make two pairs.</p>\n"
            "<div class=\"card\"><table>\n<thead><tr><th>Pair</th><th>Author</th><th>Author</th>"
            "<th class=\"number\">Forms that<br>nobody else has</th>"
            "<th class=\"number\">Forms that<br>both have</th>"
            "<th class=\"number\">Share<br>by weight</th><th class=\"number\">Score</th></tr>"
            "</thead>\n<tbody>\n",
            PAIRS_LISTED, pairs->level);
    for (int i = 0; i < pairs->n_listed; i++) {
        row_write(page, alike, i);
    }
    fputs("</tbody>\n</table></div>\n", page);
}

// Are all statements of the author given by the course?
static int author_is_given(const Alike *alike, const Author *author)
{
    for (int t = 0; t < alike->class.manifest.n_tasks; t++) {
        const Forms *forms = &author->answers[t].forms;
        for (int i = 0; i < forms->n; i++) {
            if (forms->all[i].kind == FORM_STATEMENT &&
                !alike->weights.all[forms->all[i].id].is_given) {
                return 0;
            }
        }
    }
    return 1;
}

// Whose text says nothing: it is what the course gives.
static void given_write(FILE *page, const Alike *alike)
{
    int n = 0;
    for (int i = 0; i < alike->class.n_authors; i++) {
        if (!author_is_given(alike, &alike->class.authors[i])) {
            continue;
        }
        fputs(n++ == 0
                  ? "<h2 class=\"section\" id=\"given\">As the course has it</h2>\n"
                    "<p class=\"soft\">All statements of these authors are in the solution, which "
                    "is public, or on the lab's page. Many find the same by themselves: nobody "
                    "can tell.</p>\n<div class=\"card reasons\"><p>"
                  : " &middot; ",
              page);
        author_name_write(page, alike, &alike->class.authors[i]);
    }
    fputs(n > 0 ? "</p></div>\n" : "", page);
}

// ---- The page --------------------------------------------------------------------------------

static void pair_write(FILE *page, const Alike *alike, int i)
{
    fprintf(page, "<div class=\"card\" id=\"pair-%d\">\n<div class=\"title\"><b>%d. ", i + 1,
            i + 1);
    side_by_side_write(page, alike, &alike->pairs.all[i]);
    fputs("</div>\n", page);
}

int copies_page(const Alike *alike, const char *path)
{
    OutputFile output;
    char title[256];
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    snprintf(title, sizeof title, "%s: answers that are alike", alike->class.manifest.lab);
    html_page_begin(output.file, title);
    head_write(output.file, alike);
    table_write(output.file, alike);
    given_write(output.file, alike);
    hard_write(output.file, alike);
    if (alike->pairs.n_listed > 0) {
        side_by_side_begin(output.file);
    }
    for (int i = 0; i < alike->pairs.n_listed; i++) {
        pair_write(output.file, alike, i);
    }
    html_page_end(output.file);
    return output_file_commit(&output);
}
