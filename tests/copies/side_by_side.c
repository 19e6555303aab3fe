// Writing two answers beside each other (see side_by_side.h).
#include "side_by_side.h"

#include "html.h"
#include "path.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// An answer of more lines is cut off.
enum { MOST_LINES = 400 };

// How telling a line is.
typedef enum Mark { MARK_NONE, MARK_RARE, MARK_ONLY_TWO } Mark;

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
