// Saying what makes an answer hard to compare (see hard.h).
#include "hard.h"

#include "html.h"
#include "message.h"
#include "side_by_side.h"
#include "trial.h"

#include <stdlib.h>

// So many words that are left out, or whose condition nobody knows, are worth a word.
enum { MANY_WORDS = 50 };

// What all answers of an author have together.
static Forms answers_sum(const Alike *alike, const Author *author)
{
    Forms sum = {0};
    for (int t = 0; t < alike->class.manifest.n_tasks; t++) {
        const Forms *forms = &author->answers[t].forms;
        sum.n_words += forms->n_words;
        sum.n_left_out += forms->n_left_out;
        sum.n_conditional += forms->n_conditional;
        sum.n_with_directive += forms->n_with_directive;
        sum.is_cut |= forms->is_cut;
    }
    return sum;
}

// Add a reason to those before, which may be NULL. Takes both over.
static char *reason_add(char *reasons, char *reason)
{
    if (reasons == NULL) {
        return reason;
    }
    char *both = message_new("%s; %s", reasons, reason);
    free(reasons), free(reason);
    return both;
}

char *hard_reason(const Alike *alike, const Author *author)
{
    const Forms sum = answers_sum(alike, author);
    char *reasons = NULL;
    if (author->is_given_up) {
        return message_new("more than %d s of processor time or %d MB to read: nothing is compared",
                           TRIAL_SECONDS, TRIAL_MB);
    }
    if (sum.n_with_directive > 0) {
        reasons = reason_add(reasons,
                             message_new("%d #define or #include that can hide statements or names",
                                         sum.n_with_directive));
    }
    if (sum.is_cut) {
        reasons = reason_add(reasons, message_new("a text so long that not all of it is compared"));
    }
    if (sum.n_left_out >= MANY_WORDS && 2 * sum.n_left_out > sum.n_words) {
        reasons = reason_add(reasons, message_new("%d words that never run (#if 0, if (0) { }), "
                                                  "which are left out, beside %d words",
                                                  sum.n_left_out, sum.n_words));
    }
    if (sum.n_conditional >= MANY_WORDS) {
        reasons = reason_add(reasons, message_new("%d words between #if or #ifdef and #endif, of "
                                                  "which some may never run",
                                                  sum.n_conditional));
    }
    return reasons;
}

int hard_count(const Alike *alike)
{
    int n = 0;
    for (int i = 0; i < alike->class.n_authors; i++) {
        char *reason = hard_reason(alike, &alike->class.authors[i]);
        n += reason != NULL;
        free(reason);
    }
    return n;
}

void hard_write(FILE *page, const Alike *alike)
{
    const HandedIn *class = &alike->class;
    if (class->n_unread + hard_count(alike) == 0) {
        return;
    }
    fputs("<h2 class=\"section\" id=\"hard\">Hard to compare</h2>\n"
          "<p class=\"soft\">Look at these submissions yourself. The program may not see all that "
          "is in them. Most have a harmless reason, as an attempt that was put aside.</p>\n"
          "<div class=\"card\"><table>\n<thead><tr><th>Author</th><th>Found</th></tr></thead>\n"
          "<tbody>\n",
          page);
    for (int i = 0; i < class->n_unread; i++) {
        html_write(page,
                   "<tr><td class=\"name\">%s</td>"
                   "<td>files that cannot be read: nothing is compared</td></tr>\n",
                   class->unread[i]->label);
    }
    for (int i = 0; i < class->n_authors; i++) {
        char *reason = hard_reason(alike, &class->authors[i]);
        if (reason != NULL) {
            fputs("<tr><td class=\"name\">", page);
            author_name_write(page, alike, &class->authors[i]);
            html_write(page, "</td><td>%s</td></tr>\n", reason);
        }
        free(reason);
    }
    fputs("</tbody>\n</table></div>\n", page);
}
