// Writing two answers beside each other (see side_by_side.h).
#include "side_by_side.h"

#include "html.h"
#include "marked_lines.h"
#include "message.h"
#include "path.h"

#include <unistd.h>

void author_name_write(FILE *page, const Alike *alike, const Author *author)
{
    char path[PATH_MAX];
    path_make(path, "%s/students/%s/report.html", alike->reports != NULL ? alike->reports : "",
              author->entrant->slug);
    const int has_report = alike->reports != NULL && access(path, F_OK) == 0;
    if (has_report) {
        fprintf(page, "<a href=\"students/%s/report.html\">", author->entrant->slug);
    }
    html_line(page, author->entrant->label);
    fputs(has_report ? "</a>" : "", page);
}

// ---- What is shared --------------------------------------------------------------------------

static void line_write(FILE *page, const Alike *alike, const MarkedLine *line)
{
    fputs("<span class=\"line", page);
    if (line->n_authors == 2) {
        fputs(" only\" title=\"nobody else has this", page);
    } else if (line->n_authors > 0) {
        fprintf(page, " rare\" title=\"%d of %d have this", line->n_authors,
                alike->class.n_authors);
    }
    fputs("\">", page);
    html_line(page, line->text);
    fputs("</span>", page);
}

static void answer_write(FILE *page, const Alike *alike, const Pair *pair, const Answer *answer)
{
    if (answer->text == NULL) {
        fputs("<pre><span class=\"line soft\">no answer</span></pre>\n", page);
        return;
    }
    MarkedLines lines = marked_lines(alike, pair, answer);
    fputs("<pre>", page);
    for (int i = 0, n_hidden = 0; i < lines.n; i++) {
        n_hidden += !lines.all[i].is_shown;
        if (n_hidden > 0 && (lines.all[i].is_shown || i + 1 == lines.n)) {
            fprintf(page, "<span class=\"line soft\">%d more line%s</span>", n_hidden,
                    plural((unsigned)n_hidden));
            n_hidden = 0;
        }
        if (lines.all[i].is_shown) {
            line_write(page, alike, &lines.all[i]);
        }
    }
    fputs("</pre>\n", page);
    marked_lines_free(&lines);
}

// Comments and names have no lines of their own to look at.
static void also_write(FILE *page, const Alike *alike, const Pair *pair)
{
    enum { MOST_NAMES = 100 };
    int n = 0;
    for (int id = 0; id < alike->weights.n && n < MOST_NAMES; id++) {
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

// ---- All ---------------------------------------------------------------------------------------

void side_by_side_reasons(FILE *page)
{
    fputs(
        "<div class=\"card reasons\">\n"
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

void side_by_side_begin(FILE *page)
{
    fputs("<h2 class=\"section\" id=\"side-by-side\">Side by side</h2>\n<p class=\"soft\">"
          "&#9679; marks what only these two have, &#9675; what no more than a quarter of the "
          "class has.</p>\n",
          page);
}

void side_by_side_write(FILE *page, const Alike *alike, const Pair *pair)
{
    const Manifest *manifest = &alike->class.manifest;
    const Author *authors[2] = {&alike->class.authors[pair->first],
                                &alike->class.authors[pair->second]};
    author_name_write(page, alike, authors[0]);
    fputs(" and ", page);
    author_name_write(page, alike, authors[1]);
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
}
