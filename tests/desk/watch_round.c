// What happens in a round, and what is told of it (see watch_round.h). Used by watch.c.
#include "watch_round.h"

#include "message.h"
#include "path.h"
#include "record.h"
#include "results.h"
#include "stats.h"
#include "tell.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

// ---- Telling ------------------------------------------------------------------------------------

void keys_print(const Watch *watch)
{
    printf("   h hint   g grade with new scenes   %sEnter again   q quit\n",
           look_can_be_followed(watch->desk) ? "p first wrong pixel   " : "");
    fflush(stdout);
}

// Put a text in the place of one that is owned.
static void replace(char **text, char *by)
{
    free(*text);
    *text = by;
}

void watch_publish(Watch *watch, char *state)
{
    char report[PATH_MAX];
    replace(&watch->news.state, state);
    watch->news.number++;
    path_make(report, "../grade/%.2s/report.html", watch->desk->lab->lab);
    watch_page_write(&watch->news, report);
}

// Print words of a program, each line under the round's.
static void said_print(const char *said)
{
    for (const char *line = said; *line != '\0';) {
        const int length = (int)strcspn(line, "\n");
        printf("   %.*s\n", length, line);
        line += length + (line[length] == '\n');
    }
}

// Keep of what was said the compiler's words: make's own lines are no news.
static void keep_compilers_words(char *said)
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

// ---- Steps --------------------------------------------------------------------------------------

static void start(Watch *watch, Step step, char *const words[])
{
    fflush(stdout);
    watch->step = child_start(&watch->child, words, CHILD_SHOWS) == 0 ? step : STEP_NONE;
}

static void start_compiling(Watch *watch)
{
    const char *changed[SAVED_MAX_FILES + 1];
    saved_to_make(&watch->built, &watch->taken, changed);
    watch->built = (SavedFiles){0};  // until it has ended well
    fflush(stdout);
    watch->step =
        look_start_building(&watch->look, changed, &watch->child) == 0 ? STEP_COMPILING : STEP_NONE;
}

static void start_drawing(Watch *watch)
{
    watch->step = look_start_drawing(&watch->look, &watch->child) == 0 ? STEP_DRAWING : STEP_NONE;
}

static void start_grading(Watch *watch, int is_everything)
{
    char grade[PATH_MAX];
    path_make(grade, "%s/tools/grade", watch->desk->build);
    char *words[16] = {grade, "--build", (char *)watch->desk->build, "--lab",
                       (char *)watch->desk->lab->lab};
    int n = 5;
    if (!is_everything) {
        words[n++] = "--first";
        words[n++] = "--seed";
        words[n++] = watch->seed;
    }
    if (watch->desk->device != NULL) {
        words[n++] = "--device";
        words[n++] = (char *)watch->desk->device;
    }
    start(watch, STEP_GRADING, words);
}

static void start_pixel(Watch *watch)
{
    char *lab = message_new("LAB=%.2s", watch->desk->lab->lab);
    char *at =
        message_new("AT=%d,%d", watch->look.difference.first_x, watch->look.difference.first_y);
    char *options = message_new("OPTIONS=%s", look_options(&watch->look));
    char *words[] = {
        (char *)watch->desk->make, "-s", "--no-print-directory", "pixel", lab, at, options, NULL};
    start(watch, STEP_ASKED, words);
    free(lab);
    free(at);
    free(options);
}

static void round_head_print(Watch *watch, const char *why)
{
    char time_text[16];
    const time_t now = time(NULL);
    struct tm local;
    strftime(time_text, sizeof time_text, "%H:%M:%S", localtime_r(&now, &local));
    printf("\n---- %s  %s\n", time_text, why);
    watch->round_ms = stats_clock_ms();
}

void round_begin(Watch *watch, const char *why)
{
    round_head_print(watch, why);
    replace(&watch->news.said, strdup(""));
    replace(&watch->news.changes, strdup(""));
    replace(&watch->news.command, NULL);
    watch_publish(watch, message_new("%s: compiling", why));
    start_compiling(watch);
}

// ---- What came of a step ------------------------------------------------------------------------

static double seconds_of_round(const Watch *watch)
{
    return (stats_clock_ms() - watch->round_ms) / 1000;
}

// The words are the compiler's, about a host file or a kernel. They are the news: a grading would
// only say them again.
static void tell_uncompiled(Watch *watch)
{
    watch->look.is_older = 1;
    printf("   does not compile (%.1f s)\n", seconds_of_round(watch));
    said_print(watch->child.said);
    replace(&watch->news.said, strdup(watch->child.said));
    watch_publish(watch, message_new("does not compile: not graded until it does"));
    watch->step = STEP_NONE;
    keys_print(watch);
}

static void compiling_ended(Watch *watch, int status)
{
    keep_compilers_words(watch->child.said);
    if (status == 0) {
        watch->built = watch->taken;
        said_print(watch->child.said);
        start_drawing(watch);
    } else {
        tell_uncompiled(watch);
    }
}

//   late   why it was ended before its time, or NULL
static void drawing_ended(Watch *watch, int status, const char *late)
{
    Look *look = &watch->look;
    char *told;
    look->is_older = 1;
    if (status != 0 && strstr(watch->child.said, ": error: ") != NULL) {
        tell_uncompiled(watch);
        return;
    }
    if (late != NULL) {
        told = message_new("compiles, but %s", late);
    } else if (status != 0) {
        told = message_new("compiles, but drawing failed%s", status >= 128 ? ": it crashed" : "");
        said_print(watch->child.said);
        replace(&watch->news.said, strdup(watch->child.said));
    } else {
        look_compare(look);
        told =
            look->is_older       ? message_new("compiles, but ends without a picture")
            : !look->is_compared ? message_new("compiles, and draws")
            : look->difference.n_different == 0
                ? message_new("compiles; the picture is as it should be")
                : message_new(
                      "compiles; %d pixels differ from the expected picture, the first is (%d, %d)",
                      look->difference.n_different, look->difference.first_x,
                      look->difference.first_y);
    }
    printf("   %s (%.1f s)\n", told, seconds_of_round(watch));
    replace(&watch->news.command, look_command(look));
    watch_publish(watch, message_new("%s; grading", told));
    free(told);
    start_grading(watch, 0);
}

// Add what one check gained or lost to a stream.
static void change_write(void *context, const json_t *check, int difference)
{
    fprintf((FILE *)context, "%+4d  %s: %s\n", difference, text_of(check, "id"),
            text_of(check, "title"));
}

static void grading_ended(Watch *watch, int status)
{
    enum { FULL_MARKS = 0, BELOW = 1 };
    News *news = &watch->news;
    json_t *now = status <= BELOW ? results_load(watch->results) : NULL;
    watch->step = STEP_NONE;
    if (now == NULL) {
        watch_publish(watch, message_new("not graded: see the terminal"));
        keys_print(watch);
        return;
    }
    json_t *before = news->results;
    news->results = now;
    record_note(now);
    char *changes = NULL;
    size_t length = 0;
    FILE *text = open_memstream(&changes, &length);
    if (text != NULL && before != NULL) {
        results_compare(before, now, change_write, text);
    }
    json_decref(before);
    if (text != NULL) {
        fclose(text);
        replace(&watch->news.changes, changes);
    }
    if (news->n_verdicts == NEWS_MOST_VERDICTS) {
        memmove(news->verdicts, news->verdicts + 1, sizeof news->verdicts - sizeof *news->verdicts);
        news->n_verdicts--;
    }
    news->verdicts[news->n_verdicts++] =
        (Verdict){(stats_clock_ms() - watch->start_ms) / 1000, number_of(now, "score")};
    if (watch->news.changes[0] != '\0') {
        printf("\n   since the last verdict\n");
        said_print(watch->news.changes);
    }
    // A picture without an answer is no riddle.
    if (fault_is_unanswered(results_first_fault(now))) {
        replace(&watch->news.command, NULL);
    }
    if (results_first_fault(now) != NULL) {
        printf("\n");
        tell_places(watch->desk->lab, now);
    }
    if (watch->news.command != NULL) {
        printf("\n   see why: %s\n", watch->news.command);
    }
    watch_publish(watch,
                  message_new(status == FULL_MARKS ? "every point, in %.1f s" : "graded in %.1f s",
                              seconds_of_round(watch)));
    printf("\n");
    keys_print(watch);
}

static void step_ended(Watch *watch, int status)
{
    switch (watch->step) {
    case STEP_COMPILING:
        compiling_ended(watch, status);
        break;
    case STEP_DRAWING:
        drawing_ended(watch, status, NULL);
        break;
    case STEP_GRADING:
        grading_ended(watch, status);
        break;
    default:
        watch->step = STEP_NONE;
        keys_print(watch);
    }
}

void round_go_on(Watch *watch)
{
    int status;
    const char *late = watch->step == STEP_DRAWING ? look_is_late(&watch->child) : NULL;
    if (late != NULL) {
        child_stop(&watch->child);
        drawing_ended(watch, 0, late);
    }
    if (child_has_ended(&watch->child, &status)) {
        step_ended(watch, status);
    }
}

void round_grade_anew(Watch *watch)
{
    round_head_print(watch, "with new scenes; saves are graded with the others again");
    start_grading(watch, 1);
}

void round_follow_pixel(Watch *watch)
{
    if (watch->news.command != NULL) {
        printf("%s\n", watch->news.command);
        start_pixel(watch);
    } else {
        printf("   no wrong pixel of the open scene is known, or this lab has none to follow\n");
        keys_print(watch);
    }
}
