// Writing two answers beside each other (see side_by_side.h).
#include "side_by_side.h"

#include "form_list.h"
#include "html.h"
#include "message.h"
#include "path.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void author_name_write(FILE *page, const Alike *alike, const Author *author)
{
    char path[PATH_MAX];
    path_make(path, "%s/students/%s/report.html", alike->reports != NULL ? alike->reports : "",
              author->entrant->slug);
    const int has_report = alike->reports != NULL && access(path, F_OK) == 0;
    if (has_report) {
        html_write(page, "<a href=\"students/%s/report.html\">%s</a>", author->entrant->slug,
                   author->entrant->label);
    } else {
        html_line(page, author->entrant->label);
    }
}

// ---- Lines that few others have ---------------------------------------------------------------

typedef struct MarkedLine {
    char *text;     // in MarkedLines.text
    int n_authors;  // of the rarest form at this line that both have, or 0 if none is rare
    int is_shown;
} MarkedLine;

typedef struct MarkedLines {
    char *text;  // owned
    MarkedLine *all;
    int n;
} MarkedLines;

// An answer of no more lines is shown whole; of a longer one so many around each marked line.
enum { MOST_LINES = 400, LINES_AROUND = 4 };

static void lines_split(const char *text, MarkedLines *lines)
{
    lines->text = message_new("%s", text);
    for (char *rest = lines->text; rest != NULL && *rest != '\0';) {
        lines->all = array_grow(lines->all, lines->n, sizeof *lines->all);
        lines->all[lines->n++] = (MarkedLine){.text = strsep(&rest, "\n")};
    }
}

static int is_rare(const Alike *alike, const Pair *pair, const Form *form)
{
    return form->kind != FORM_NAME &&
           4 * alike->weights.all[form->id].n_authors <= alike->class.n_authors + 4 &&
           is_shared(alike, pair, form->id);
}

static void lines_mark(const Alike *alike, const Pair *pair, const Forms *forms, MarkedLines *lines)
{
    for (int i = 0; i < forms->n; i++) {
        const Form *form = &forms->all[i];
        if (!is_rare(alike, pair, form)) {
            continue;
        }
        const int n_authors = alike->weights.all[form->id].n_authors;
        for (int at = form->first_line - 1; at < form->last_line && at < lines->n; at++) {
            int *fewest = &lines->all[at].n_authors;
            *fewest = *fewest == 0 || n_authors < *fewest ? n_authors : *fewest;
        }
    }
}

static int is_empty(const char *line)
{
    return line[strspn(line, " \t\r\v\f")] == '\0';
}

// Show what is near marked lines.
static void lines_near(MarkedLines *lines)
{
    for (int i = 0; i < lines->n; i++) {
        const int is_marked = lines->all[i].n_authors > 0;
        for (int near = i - LINES_AROUND; is_marked && near <= i + LINES_AROUND; near++) {
            if (near >= 0 && near < lines->n) {
                lines->all[near].is_shown = 1;
            }
        }
    }
}

// Choose what is shown, MOST_LINES at most.
static void lines_choose(MarkedLines *lines)
{
    int n_shown = 0, n_kept = 0;
    for (int i = 0; i < lines->n; i++) {
        const int is_next_empty =
            i > 0 && is_empty(lines->all[i].text) && is_empty(lines->all[i - 1].text);
        lines->all[i].is_shown = !is_next_empty;
        n_kept += !is_next_empty;
    }
    if (n_kept > MOST_LINES) {
        for (int i = 0; i < lines->n; i++) {
            lines->all[i].is_shown = 0;
        }
        lines_near(lines);
    }
    for (int i = 0; i < lines->n; i++) {
        lines->all[i].is_shown &= n_shown < MOST_LINES;
        n_shown += lines->all[i].is_shown;
    }
}

// The lines of an answer that is there, with the forms that both authors of a pair and no more than
// a quarter of the class have. Of a long answer only what is near such forms is shown, and of a run
// of empty lines only the first.
static MarkedLines marked_lines(const Alike *alike, const Pair *pair, const Answer *answer)
{
    MarkedLines lines = {0};
    lines_split(answer->text, &lines);
    lines_mark(alike, pair, &answer->forms, &lines);
    lines_choose(&lines);
    return lines;
}

static void marked_lines_free(MarkedLines *lines)
{
    free(lines->text);
    free(lines->all);
    *lines = (MarkedLines){0};
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
    html_write(page, "\">%s</span>", line->text);
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
            fputs(n++ == 0 ? "<p class=\"soft\">Names that few others have: " : ", ", page);
            html_write(page, "<code>%s</code>", weight->form->text);
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
        html_write(page, "<div class=\"answers\"><h3>%s</h3>\n", manifest->tasks[t].id);
        for (int a = 0; a < 2; a++) {
            answer_write(page, alike, pair, &authors[a]->answers[t]);
        }
        fputs("</div>\n", page);
    }
}
