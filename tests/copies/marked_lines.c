// Choosing the lines of an answer for the page (see marked_lines.h).
#include "marked_lines.h"

#include "form_list.h"
#include "message.h"

#include <stdlib.h>
#include <string.h>

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

MarkedLines marked_lines(const Alike *alike, const Pair *pair, const Answer *answer)
{
    MarkedLines lines = {0};
    lines_split(answer->text, &lines);
    lines_mark(alike, pair, &answer->forms, &lines);
    lines_choose(&lines);
    return lines;
}

void marked_lines_free(MarkedLines *lines)
{
    free(lines->text);
    free(lines->all);
    *lines = (MarkedLines){0};
}
