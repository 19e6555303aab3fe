// What the watch tells of a round (see watch.h). Used by watch_round.c.
#include "watch.h"

#include "path.h"
#include "results.h"
#include "stats.h"
#include "tell.h"

#include <stdlib.h>
#include <string.h>

void keys_print(const Watch *watch)
{
    printf("   h hint   g grade with new scenes   %sEnter again   q quit\n",
           look_can_be_followed(watch->desk) ? "p first wrong pixel   " : "");
    fflush(stdout);
}

void text_replace(char **text, char *by)
{
    free(*text);
    *text = by;
}

void watch_publish(Watch *watch, char *state)
{
    char report[PATH_MAX];
    text_replace(&watch->news.state, state);
    watch->news.number++;
    path_make(report, "../grade/%.2s/report.html", watch->desk->lab->lab);
    watch_page_write(&watch->news, report);
}

void said_print(const char *said)
{
    for (const char *line = said; *line != '\0';) {
        const int length = (int)strcspn(line, "\n");
        printf("   %.*s\n", length, line);
        line += length + (line[length] == '\n');
    }
}

void keep_compilers_words(char *said)
{
    static const char *const own[] = {"make", "  compile ", "  link "};
    char *kept = said;
    for (const char *line = said; *line != '\0';) {
        const size_t length = strcspn(line, "\n") + (strchr(line, '\n') != NULL);
        int is_own = 0;
        for (size_t i = 0; i < sizeof own / sizeof *own; i++) {
            is_own |= strncmp(line, own[i], strlen(own[i])) == 0;
        }
        if (!is_own) {
            memmove(kept, line, length);
            kept += length;
        }
        line += length;
    }
    *kept = '\0';
}

// ---- Verdicts -----------------------------------------------------------------------------------

double seconds_of_round(const Watch *watch)
{
    return (stats_clock_ms() - watch->round_ms) / 1000;
}

const char *driver_name(const Watch *watch)
{
    return watch->desk->device != NULL ? watch->desk->device : "PoCL";
}

// Add what one check gained or lost to a stream.
static void change_write(void *context, const json_t *check, int difference)
{
    fprintf((FILE *)context, "%+4d  %s: %s\n", difference, text_of(check, "id"),
            text_of(check, "title"));
}

void verdict_take(Watch *watch, json_t *now, const char *since)
{
    News *news = &watch->news;
    json_t *before = news->results;
    news->results = now;
    char *changes = NULL;
    size_t length = 0;
    FILE *text = open_memstream(&changes, &length);
    if (text != NULL && before != NULL) {
        results_compare(before, now, change_write, text);
    }
    json_decref(before);
    if (text != NULL) {
        fclose(text);
        text_replace(&news->changes, changes);
    }
    if (news->n_verdicts == NEWS_MOST_VERDICTS) {
        memmove(news->verdicts, news->verdicts + 1, sizeof news->verdicts - sizeof *news->verdicts);
        news->n_verdicts--;
    }
    news->verdicts[news->n_verdicts++] =
        (Verdict){(stats_clock_ms() - watch->start_ms) / 1000, number_of(now, "score")};
    if (news->changes[0] != '\0') {
        printf("\n   since %s\n", since);
        said_print(news->changes);
    }
    tell_places(watch->desk->lab, now);
}
