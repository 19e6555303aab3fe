// The watch (see watch.h).
//
// One loop looks at the files, at what runs and at the keys. A save starts a round: compile, draw,
// grade. One command runs at a time; a save in the middle of a round ends it and starts the next.
// Only one's own code is watched, so drawing runs it as the student does, and grading in the
// sandbox. Read next: saved.h, child.h, watch_page.h.
#include "watch.h"

#include "child.h"
#include "complain.h"
#include "look.h"
#include "message.h"
#include "path.h"
#include "record.h"
#include "results.h"
#include "saved.h"
#include "stats.h"
#include "tell.h"
#include "watch_page.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/signalfd.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

enum {
    LOOK_MS = 50,
    // An editor may write a file in parts: it is complete when it has stayed the same for so long.
    QUIET_MS = 80,
};

typedef enum Step { STEP_NONE, STEP_COMPILING, STEP_DRAWING, STEP_GRADING, STEP_ASKED } Step;

typedef struct Watch {
    const Desk *desk;
    Look look;               // the open scene, and the folder of the page
    char results[PATH_MAX];  // the grader's
    char seed[24];           // the same for every save: what is gained and lost is the student's
    SavedFiles seen;         // at the last look
    double seen_ms;          // since when they are so
    SavedFiles taken;        // that the last round began with
    SavedFiles built;        // that the program was made of
    Step step;
    Child child;
    json_t *before, *now;                    // verdicts
    char *state, *said, *changes, *command;  // of the news; owned
    News news;
    char keys[8];  // that wait for the round's end
    int n_keys;
    int has_terminal;  // for keys
    double start_ms, round_ms;
} Watch;

// ---- Telling ------------------------------------------------------------------------------------

static void keys_print(const Watch *watch)
{
    printf("   h hint   g grade with new scenes   %sEnter again   q quit\n",
           look_can_be_followed(&watch->look) ? "p first wrong pixel   " : "");
    fflush(stdout);
}

// Put a text in the place of one that is owned.
static void replace(char **text, char *by)
{
    free(*text);
    *text = by;
}

// Tell the page.
static void publish(Watch *watch, char *state)
{
    char report[PATH_MAX];
    replace(&watch->state, state);
    watch->news.number++;
    watch->news.state = watch->state;
    watch->news.said = watch->said;
    watch->news.changes = watch->changes;
    watch->news.command = watch->command;
    watch->news.results = watch->now;
    watch->news.look = &watch->look;
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

static void round_begin(Watch *watch, const char *why)
{
    round_head_print(watch, why);
    replace(&watch->said, strdup(""));
    replace(&watch->changes, strdup(""));
    replace(&watch->command, NULL);
    publish(watch, message_new("%s: compiling", why));
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
    watch->look.has_picture = 0;
    printf("   does not compile (%.1f s)\n", seconds_of_round(watch));
    said_print(watch->child.said);
    replace(&watch->said, strdup(watch->child.said));
    publish(watch, message_new("does not compile: not graded until it does"));
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

static void drawing_ended(Watch *watch, int status, int is_late)
{
    Look *look = &watch->look;
    char *told;
    look->has_picture = 0;
    if (status != 0 && strstr(watch->child.said, ": error: ") != NULL) {
        tell_uncompiled(watch);
        return;
    }
    if (is_late) {
        told = message_new("compiles; drawing had no end in %d s", LOOK_MOST_MS / 1000);
    } else if (status != 0) {
        told = message_new("compiles, but drawing failed%s", status >= 128 ? ": it crashed" : "");
        said_print(watch->child.said);
        replace(&watch->said, strdup(watch->child.said));
    } else {
        look_compare(look);
        told =
            !look->has_picture  ? message_new("compiles, but ends without a picture")
            : !look->has_figure ? message_new("compiles, and draws")
            : look->difference.n_different == 0
                ? message_new("compiles; the picture is as it should be")
                : message_new(
                      "compiles; %d pixels differ from the expected picture, the first is (%d, %d)",
                      look->difference.n_different, look->difference.first_x,
                      look->difference.first_y);
    }
    printf("   %s (%.1f s)\n", told, seconds_of_round(watch));
    replace(&watch->command, look_command(look));
    publish(watch, message_new("%s; grading", told));
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
        publish(watch, message_new("not graded: see the terminal"));
        keys_print(watch);
        return;
    }
    json_decref(watch->before);
    watch->before = watch->now;
    watch->now = now;
    record_note(now);
    char *changes = NULL;
    size_t length = 0;
    FILE *text = open_memstream(&changes, &length);
    if (text != NULL && watch->before != NULL) {
        results_compare(watch->before, now, change_write, text);
    }
    if (text != NULL) {
        fclose(text);
        replace(&watch->changes, changes);
    }
    if (news->n_verdicts == NEWS_MOST_VERDICTS) {
        memmove(news->verdicts, news->verdicts + 1, sizeof news->verdicts - sizeof *news->verdicts);
        news->n_verdicts--;
    }
    news->verdicts[news->n_verdicts++] =
        (Verdict){(stats_clock_ms() - watch->start_ms) / 1000, number_of(now, "score")};
    if (watch->changes[0] != '\0') {
        printf("\n   since the last verdict\n");
        said_print(watch->changes);
    }
    // A picture without an answer is no riddle.
    if (fault_is_unanswered(results_first_fault(now))) {
        replace(&watch->command, NULL);
    }
    if (watch->command != NULL) {
        printf("\n   see why: %s\n", watch->command);
    }
    publish(watch, message_new(status == FULL_MARKS ? "every point, in %.1f s" : "graded in %.1f s",
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
        drawing_ended(watch, status, 0);
        break;
    case STEP_GRADING:
        grading_ended(watch, status);
        break;
    default:
        watch->step = STEP_NONE;
        keys_print(watch);
    }
}

// ---- The loop -----------------------------------------------------------------------------------

// Has something been saved that no round has begun with? Then begin one.
static void look_at_files(Watch *watch)
{
    SavedFiles now;
    char folder[PATH_MAX];
    path_make(folder, "labs/%s", watch->desk->lab->lab);
    saved_look(folder, &now);
    const double time_ms = stats_clock_ms();
    if (now.sum != watch->seen.sum) {
        watch->seen = now;
        watch->seen_ms = time_ms;
    } else if (now.sum != watch->taken.sum && time_ms - watch->seen_ms >= QUIET_MS) {
        char names[256];
        saved_changes(&watch->taken, &now, names, sizeof names);
        char *why = watch->taken.n_files == 0 ? strdup("start") : message_new("saved: %s", names);
        if (watch->step != STEP_NONE) {
            printf("   (saved again: this is not graded to its end)\n");
        }
        child_stop(&watch->child);
        watch->taken = now;
        round_begin(watch, why);
        free(why);
    }
}

// Do what a key asks for, when nothing runs.
static void answer(Watch *watch, char key)
{
    switch (key) {
    case 'h':
        tell_hint(watch->desk->lab);
        keys_print(watch);
        break;
    case 'g':
        round_head_print(watch, "with new scenes; saves are graded with the others again");
        start_grading(watch, 1);
        break;
    case 'p':
        if (watch->command != NULL) {
            printf("%s\n", watch->command);
            start_pixel(watch);
        } else {
            printf(
                "   no wrong pixel of the open scene is known, or this lab has none to follow\n");
            keys_print(watch);
        }
        break;
    case '\n':
    case '\r':
        round_begin(watch, "again");
        break;
    default:
        keys_print(watch);
    }
    fflush(stdout);
}

// Keys without Enter and without echo. Returns 1 where there is a terminal, which `before`
// describes.
static int terminal_begin(struct termios *before)
{
    if (!isatty(STDIN_FILENO) || tcgetattr(STDIN_FILENO, before) != 0) {
        return 0;
    }
    struct termios keys = *before;
    keys.c_lflag &= (tcflag_t) ~(ICANON | ECHO);
    return tcsetattr(STDIN_FILENO, TCSANOW, &keys) == 0;
}

// Behind Ctrl-Z and fg the shell has set the terminal as it likes it. Returns the signal's number.
static int signal_read(Watch *watch, int signals)
{
    struct signalfd_siginfo heard;
    if (read(signals, &heard, sizeof heard) != sizeof heard) {
        return 0;
    }
    if (heard.ssi_signo == SIGCONT && watch->has_terminal) {
        struct termios unused;
        terminal_begin(&unused);
        keys_print(watch);
    }
    return (int)heard.ssi_signo;
}

static int is_late(const Watch *watch)
{
    return watch->step == STEP_DRAWING && stats_clock_ms() - watch->child.start_ms > LOOK_MOST_MS;
}

// Until a signal or a key.
static void watch_loop(Watch *watch, int signals)
{
    struct pollfd ready[3] = {{signals, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}, {-1, POLLIN, 0}};
    for (;;) {
        int status;
        ready[2].fd = watch->child.output;
        poll(ready, 3, LOOK_MS);
        if (ready[0].revents != 0 && signal_read(watch, signals) != SIGCONT) {
            return;
        }
        if (access(watch->look.folder, W_OK) != 0) {
            child_stop(&watch->child);
            complain("make watch: %s is gone: start make watch again", watch->look.folder);
            return;
        }
        if (ready[1].revents != 0) {
            char key;
            if (read(STDIN_FILENO, &key, 1) != 1) {
                ready[1].fd = -1;  // nobody is there to press keys
            } else if (key == 'q') {
                return;
            } else if (watch->n_keys < (int)sizeof watch->keys) {
                watch->keys[watch->n_keys++] = key;
            }
        }
        if (watch->child.output >= 0 && ready[2].revents != 0) {
            child_read(&watch->child);
        }
        if (is_late(watch)) {
            child_stop(&watch->child);
            drawing_ended(watch, 0, 1);
        }
        if (child_has_ended(&watch->child, &status)) {
            step_ended(watch, status);
        }
        look_at_files(watch);
        if (watch->n_keys > 0 && watch->step == STEP_NONE) {
            const char key = watch->keys[0];
            memmove(watch->keys, watch->keys + 1, (size_t)--watch->n_keys);
            answer(watch, key);
        }
    }
}

// One watch at a time: two would write one page, and grade into one folder. Returns the descriptor
// that holds the lock, or -1 after one message.
static int lock_take(const Watch *watch)
{
    char path[PATH_MAX];
    path_make(path, "%s/lock", watch->look.folder);
    const int lock = open(path, O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) == 0) {
        return lock;
    }
    complain(errno == EWOULDBLOCK ? "make watch: one runs here already: end it with q first"
                                  : "make watch: %s: cannot be locked: %s",
             path, strerror(errno));
    if (lock >= 0) {
        close(lock);
    }
    return -1;
}

static void paths_make(Watch *watch)
{
    const char *build = watch->desk->build, *lab = watch->desk->lab->lab;
    path_make(watch->results, "%s/grade/%.2s/results.json", build, lab);
    snprintf(watch->seed, sizeof watch->seed, "%ld", 1 + (long)time(NULL) % 65535);
}

int watch_run(const Desk *desk)
{
    static Watch watch;
    struct termios before;
    sigset_t set;
    watch = (Watch){.desk = desk, .child = {.output = -1}, .start_ms = stats_clock_ms()};
    look_open(desk, &watch.look);
    paths_make(&watch);
    const int lock = lock_take(&watch);
    if (lock < 0) {
        return -1;
    }
    replace(&watch.said, strdup(""));
    replace(&watch.changes, strdup(""));
    sigemptyset(&set);
    sigaddset(&set, SIGINT), sigaddset(&set, SIGTERM), sigaddset(&set, SIGHUP),
        sigaddset(&set, SIGCONT);
    sigprocmask(SIG_BLOCK, &set, NULL);
    const int signals = signalfd(-1, &set, SFD_CLOEXEC);
    watch.has_terminal = terminal_begin(&before);
    printf("Watching labs/%s: save a file. Open %s/index.html in a browser.\n", desk->lab->lab,
           watch.look.folder);
    watch_loop(&watch, signals);
    child_stop(&watch.child);
    if (access(watch.look.folder, W_OK) == 0) {
        publish(&watch,
                message_new("the watch has ended; make watch LAB=%.2s goes on", desk->lab->lab));
    }
    if (watch.has_terminal) {
        tcsetattr(STDIN_FILENO, TCSANOW, &before);
    }
    printf("\nStopped; what was reached is in make progress.\n");
    json_decref(watch.before);
    json_decref(watch.now);
    look_close(&watch.look);
    free(watch.child.said);
    replace(&watch.state, NULL), replace(&watch.said, NULL), replace(&watch.changes, NULL);
    replace(&watch.command, NULL);
    close(signals);
    close(lock);
    return 0;
}
