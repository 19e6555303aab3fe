// What happens in a round (see watch.h). Used by watch.c. Read next: watch_tell.c.
#include "watch.h"

#include "message.h"
#include "path.h"
#include "record.h"
#include "results.h"
#include "stats.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

// The grader's exit status.
enum { GRADED_FULL = 0, GRADED_BELOW = 1 };

// Processor time without a driver: a right answer takes a tenth of it.
#define NATIVE_SECONDS "2"

// ---- Steps --------------------------------------------------------------------------------------

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

// Grade what is saved, with the scenes of this watch or, for everything, with new ones.
//   folder   of what to grade with: the build folder, or the one without a driver
static void start_grading(Watch *watch, const char *folder, int is_everything)
{
    const Desk *desk = watch->desk;
    const int is_native = folder == desk->native;
    char grade[PATH_MAX], answers[PATH_MAX];
    path_make(grade, "%s/tools/grade", desk->build);
    path_make(answers, "%s/%s", watch->look.folder, is_native ? "native-answers" : "answers");
    char *words[20] = {grade, "--build", (char *)folder, "--lab", (char *)desk->lab->lab};
    int n = 5;
    if (!is_everything) {
        char *const kept[] = {"--first", "--seed", watch->seed, "--answers", answers};
        memcpy(words + n, kept, sizeof kept);
        n += sizeof kept / sizeof *kept;
    }
    if (is_native) {
        // Drawing runs it outside the sandbox, too.
        char *const quick[] = {"--sandbox",    "none",         "--device",      "0",
                               "--time-limit", NATIVE_SECONDS, "--verdict-only"};
        memcpy(words + n, quick, sizeof quick);
    } else if (desk->device != NULL) {
        words[n++] = "--device";
        words[n++] = (char *)desk->device;
    }
    fflush(stdout);
    const ChildOutput output = is_native || watch->is_judged ? CHILD_IS_READ : CHILD_SHOWS;
    watch->step = child_start(&watch->child, words, output) != 0 ? STEP_NONE
                  : is_native                                    ? STEP_JUDGING
                                                                 : STEP_GRADING;
}

static void start_pixel(Watch *watch)
{
    char *lab = message_new("LAB=%.2s", watch->desk->lab->lab);
    char *at =
        message_new("AT=%d,%d", watch->look.difference.first_x, watch->look.difference.first_y);
    char *options = message_new("OPTIONS=%s", look_options(&watch->look));
    char *words[] = {
        (char *)watch->desk->make, "-s", "--no-print-directory", "pixel", lab, at, options, NULL};
    fflush(stdout);
    watch->step = child_start(&watch->child, words, CHILD_SHOWS) == 0 ? STEP_ASKED : STEP_NONE;
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
    text_replace(&watch->news.said, strdup(""));
    text_replace(&watch->news.changes, strdup(""));
    text_replace(&watch->news.command, NULL);
    watch->look.is_older = 1;  // the picture, until it is drawn anew
    watch->is_judged = 0;
    watch_publish(watch, message_new("%s: compiling", why));
    if (watch->desk->native != NULL && !watch->has_no_native) {
        start_grading(watch, watch->desk->native, 0);
    } else {
        start_compiling(watch);
    }
}

// ---- What came of a step ------------------------------------------------------------------------

// The words are the compiler's, about a host file or a kernel. They are the news: a grading would
// only say them again.
static void tell_uncompiled(Watch *watch)
{
    watch->look.is_older = 1;
    printf("   does not compile (%.1f s)\n", seconds_of_round(watch));
    said_print(watch->child.said);
    text_replace(&watch->news.said, strdup(watch->child.said));
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
        text_replace(&watch->news.said, strdup(watch->child.said));
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
    text_replace(&watch->news.command, look_command(look));
    watch_publish(watch, message_new("%s; grading", told));
    free(told);
    start_grading(watch, watch->desk->build, 0);
}

// Judged without a driver: what compiles so is told at once, and the driver's verdict comes later.
// Else nothing is told, as the driver may know more of OpenCL; and where grading itself failed, it
// is not tried again.
static void judging_ended(Watch *watch, int status)
{
    char path[PATH_MAX];
    path_make(path, "%s/grade/%.2s/results.json", watch->desk->native, watch->desk->lab->lab);
    json_t *now = status <= GRADED_BELOW ? results_load(path) : NULL;
    watch->has_no_native = status > GRADED_BELOW;
    if (now != NULL && results_are_of_compiled(now)) {
        printf("%s", watch->child.said);
        verdict_take(watch, now, "the last verdict");
        watch->is_judged = 1;
        printf("\n   judged in %.1f s; now with %s\n", seconds_of_round(watch), driver_name(watch));
        fflush(stdout);
        watch_publish(watch, message_new("judged in %.1f s; now with %s", seconds_of_round(watch),
                                         driver_name(watch)));
    } else {
        json_decref(now);
    }
    start_compiling(watch);
}

static void change_pass_over(void *context, const json_t *check, int difference)
{
    (void)context, (void)check, (void)difference;
}

// The driver's verdict counts: it is told where no other was, or that was another one.
static void grading_told(Watch *watch, json_t *now)
{
    News *news = &watch->news;
    int is_same = 0;
    if (watch->is_judged) {
        is_same = results_compare(news->results, now, change_pass_over, NULL) == 0;
        printf(is_same ? "   %s says the same (%.1f s)\n"
                       : "   %s judges otherwise, and that counts (%.1f s):\n\n",
               driver_name(watch), seconds_of_round(watch));
    }
    if (is_same) {
        json_decref(news->results);
        news->results = now;
        return;
    }
    printf("%s", watch->child.said);  // nothing, where it was shown while it ran
    verdict_take(watch, now, watch->is_judged ? "the verdict above" : "the last verdict");
}

static void grading_ended(Watch *watch, int status)
{
    News *news = &watch->news;
    json_t *now = status <= GRADED_BELOW ? results_load(watch->results) : NULL;
    watch->step = STEP_NONE;
    if (now == NULL) {
        printf("%s", watch->child.said);
        watch_publish(watch, message_new("not graded: see the terminal"));
        keys_print(watch);
        return;
    }
    grading_told(watch, now);
    record_note(now);
    // A picture without an answer is no riddle.
    if (fault_is_unanswered(results_first_fault(now))) {
        text_replace(&news->command, NULL);
    }
    if (news->command != NULL) {
        printf("\n   see why: %s\n", news->command);
    }
    watch_publish(watch,
                  message_new(status == GRADED_FULL ? "every point, in %.1f s" : "graded in %.1f s",
                              seconds_of_round(watch)));
    printf("\n");
    keys_print(watch);
}

static void step_ended(Watch *watch, int status)
{
    switch (watch->step) {
    case STEP_JUDGING:
        judging_ended(watch, status);
        break;
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
    watch->is_judged = 0;
    start_grading(watch, watch->desk->build, 1);
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
