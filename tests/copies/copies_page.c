// copies.html: pairs of answers side by side (see alike.h).
//
// It asks the instructor to look, and never says that somebody copied. Read next: html.h.
#include "alike.h"

#include "html.h"
#include "output_file.h"
#include "path.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// An answer of more lines is cut off.
enum { MOST_LINES = 400 };

// How telling a line is.
typedef enum Mark { MARK_NONE, MARK_RARE, MARK_ONLY_TWO } Mark;

static void name_write(FILE *page, const Alike *alike, const Author *author)
{
    char path[PATH_MAX];
    path_make(path, "%s/students/%s/report.html", alike->output, author->entrant->slug);
    const int has_report = access(path, F_OK) == 0;
    if (has_report) {
        fprintf(page, "<a href=\"students/%s/report.html\">", author->entrant->slug);
    }
    html_line(page, author->entrant->label);
    fputs(has_report ? "</a>" : "", page);
}

// ---- The head --------------------------------------------------------------------------------

static void facts_write(FILE *page, const Alike *alike)
{
    const Pairs *pairs = &alike->pairs;
    fprintf(page,
            "<dl class=\"facts\">\n<div><dt>Authors</dt><dd>%d</dd></div>\n"
            "<div><dt>Without an answer</dt><dd>%d</dd></div>\n"
            "<div><dt>Pairs compared</dt><dd>%d</dd></div>\n"
            "<div><dt>Pairs to look at</dt><dd>%d</dd></div>\n</dl>\n",
            alike->class.n_authors, alike->class.n_without, pairs->n_compared, pairs->n_listed);
}

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
                "the same text would be listed. About the other %d the page says nothing.",
                pairs->n_tellable, n, n - pairs->n_tellable);
    }
    fputs("</p>\n", page);
}

static void head_write(FILE *page, const Alike *alike)
{
    fputs("<header>\n<p class=\"lab\">", page);
    html_line(page, alike->class.manifest.lab);
    fputs("</p>\n<h1>", page);
    html_line(page, alike->class.manifest.title);
    fputs(": answers that are alike</h1>\n", page);
    facts_write(page, alike);
    reach_write(page, alike);
    fputs(
        "</header>\n<div class=\"card reasons\">\n"
        "<p><b>Look at these pairs, and talk to their authors.</b> The page counts what is alike. "
        "It does not know why, and it is no proof. Two people also write alike if</p>\n<ul>\n"
        "<li>they sat together, or handed in as a team,</li>\n"
        "<li>both followed an example: of a teacher, a book, a page, or a program that writes "
        "code,</li>\n"
        "<li>both made the same well-known mistake,</li>\n"
        "<li>the task leaves few ways to write it.</li>\n</ul>\n"
        "<p class=\"soft\">This page is for you alone: it has names and answers. Nothing on it "
        "changes a score, and no student gets it.</p>\n</div>\n",
        page);
}

// ---- The table -------------------------------------------------------------------------------

static void row_write(FILE *page, const Alike *alike, int i)
{
    const Pair *pair = &alike->pairs.all[i];
    const Author *authors = alike->class.authors;
    fprintf(page, "<tr><td class=\"number\"><a href=\"#pair-%d\">%d</a></td><td class=\"name\">",
            i + 1, i + 1);
    html_line(page, authors[pair->first].entrant->label);
    fputs("</td><td class=\"name\">", page);
    html_line(page, authors[pair->second].entrant->label);
    fprintf(page,
            "</td><td class=\"number\">%d</td><td class=\"number\">%d</td>"
            "<td class=\"number\">%.0f%%</td><td class=\"number\">%.1f"
            "<div class=\"bar speed\"><div style=\"width: %.1f%%\"></div></div></td></tr>\n",
            pair->n_only_two, pair->n_shared, 100 * pair->share, pair->score,
            100 * pair->score / alike->pairs.all[0].score);
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
            "its names, its order and its spelling, or a comment, or a name. What the course "
            "gives does not count. A form weighs the more, the fewer of the class have it. The "
            "score is the weight of what both have, times its share; pairs are listed from %.1f "
            "on, which grows with the class.</p>\n"
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
                  ? "<h2 class=\"section\" id=\"given\">Nothing of their own</h2>\n"
                    "<p class=\"soft\">All statements of these authors are in the solution, which "
                    "is public, or on the lab's page. Many find the same by themselves: nobody "
                    "can tell.</p>\n<div class=\"card reasons\"><p>"
                  : " &middot; ",
              page);
        name_write(page, alike, &alike->class.authors[i]);
    }
    fputs(n > 0 ? "</p></div>\n" : "", page);
}

// ---- Side by side ----------------------------------------------------------------------------

int is_shared(const Alike *alike, const Pair *pair, int id)
{
    const HandedIn *class = &alike->class;
    return alike->weights.all[id].nats > 0 && author_has(class, &class->authors[pair->first], id) &&
           author_has(class, &class->authors[pair->second], id);
}

// The most telling of the shared forms of line `number`; *n_authors have it.
static Mark mark_of(const Alike *alike, const Pair *pair, const Forms *forms, int number,
                    int *n_authors)
{
    Mark mark = MARK_NONE;
    for (int i = 0; i < forms->n; i++) {
        const Form *form = &forms->all[i];
        const Weight *weight = &alike->weights.all[form->id];
        if (form->kind == FORM_NAME || number < form->first_line || number > form->last_line ||
            4 * weight->n_authors > alike->class.n_authors + 4 ||
            !is_shared(alike, pair, form->id)) {
            continue;
        }
        if (mark == MARK_NONE || weight->n_authors < *n_authors) {
            *n_authors = weight->n_authors;
            mark = weight->n_authors == 2 ? MARK_ONLY_TWO : MARK_RARE;
        }
    }
    return mark;
}

static void line_write(FILE *page, const Alike *alike, const char *line, Mark mark, int n_authors)
{
    fputs("<span class=\"line", page);
    if (mark == MARK_ONLY_TWO) {
        fputs(" only\" title=\"nobody else has this", page);
    } else if (mark == MARK_RARE) {
        fprintf(page, " rare\" title=\"%d of %d have this", n_authors, alike->class.n_authors);
    }
    fputs("\">", page);
    html_line(page, line);
    fputs("</span>", page);
}

static void answer_write(FILE *page, const Alike *alike, const Pair *pair, const Answer *answer)
{
    char *text = answer->text != NULL ? strdup(answer->text) : NULL;
    char *rest = text;
    int number = 1;
    fputs("<pre>", page);
    for (; rest != NULL && *rest != '\0' && number <= MOST_LINES; number++) {
        char *line = strsep(&rest, "\n");
        int n_authors = 0;
        const Mark mark = mark_of(alike, pair, &answer->forms, number, &n_authors);
        line_write(page, alike, line, mark, n_authors);
    }
    fputs(text == NULL                    ? "<span class=\"line soft\">no answer</span>"
          : rest != NULL && *rest != '\0' ? "<span class=\"line soft\">and more lines</span>"
                                          : "",
          page);
    fputs("</pre>\n", page);
    free(text);
}

// Comments and names have no lines of their own to look at.
static void also_write(FILE *page, const Alike *alike, const Pair *pair)
{
    int n = 0;
    for (int id = 0; id < alike->weights.n; id++) {
        const Weight *weight = &alike->weights.all[id];
        if (weight->form->kind == FORM_NAME && weight->n_authors > 1 &&
            4 * weight->n_authors <= alike->class.n_authors + 4 && is_shared(alike, pair, id)) {
            fputs(n++ == 0 ? "<p class=\"soft\">Names that few others have: <code>" : ", <code>",
                  page);
            html_line(page, weight->form->text);
            fputs("</code>", page);
        }
    }
    fputs(n > 0 ? "</p>\n" : "", page);
}

static void pair_write(FILE *page, const Alike *alike, int i)
{
    const Pair *pair = &alike->pairs.all[i];
    const Manifest *manifest = &alike->class.manifest;
    const Author *authors[2] = {&alike->class.authors[pair->first],
                                &alike->class.authors[pair->second]};
    fprintf(page, "<div class=\"card\" id=\"pair-%d\">\n<div class=\"title\"><b>%d. ", i + 1,
            i + 1);
    name_write(page, alike, authors[0]);
    fputs(" and ", page);
    name_write(page, alike, authors[1]);
    fprintf(page, "</b><span class=\"number\">%.1f</span></div>\n", pair->score);
    fprintf(page,
            "<p class=\"soft\">%d forms that both have, %d of them nobody else; %.0f%% by "
            "weight.</p>\n",
            pair->n_shared, pair->n_only_two, 100 * pair->share);
    also_write(page, alike, pair);
    for (int t = 0; t < manifest->n_tasks; t++) {
        fputs("<div class=\"answers\"><h3>", page);
        html_line(page, manifest->tasks[t].id);
        fputs("</h3>\n", page);
        for (int a = 0; a < 2; a++) {
            answer_write(page, alike, pair, &authors[a]->answers[t]);
        }
        fputs("</div>\n", page);
    }
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
    if (alike->pairs.n_listed > 0) {
        fputs("<h2 class=\"section\" id=\"side-by-side\">Side by side</h2>\n<p class=\"soft\">"
              "&#9679; marks what only these two have, &#9675; what no more than a quarter of the "
              "class has.</p>\n",
              output.file);
    }
    for (int i = 0; i < alike->pairs.n_listed; i++) {
        pair_write(output.file, alike, i);
    }
    html_page_end(output.file);
    return output_file_commit(&output);
}
