// The watch (see watch.h).
//
// One loop looks at the files, at what runs and at the keys. A save starts a round: compile, draw,
// grade. One command runs at a time; a save in the middle of a round ends it and starts the next.
// Only one's own code is watched, so drawing runs it as the student does, and grading in the
// sandbox. Read next: watch_round.c, saved.h, child.h.
#include "watch.h"

#include "complain.h"
#include "message.h"
#include "path.h"
#include "stats.h"
#include "tell.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

enum {
    LOOK_MS = 25,
    // An editor may write a file in parts: it is complete when it has stayed the same for so long.
    QUIET_MS = 40,
};

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
        round_grade_anew(watch);
        break;
    case 'p':
        round_follow_pixel(watch);
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

// Until a signal or a key.
static void watch_loop(Watch *watch, int signals)
{
    struct pollfd ready[3] = {{signals, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}, {-1, POLLIN, 0}};
    for (;;) {
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
        round_go_on(watch);
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

// A folder for the solution's answers to this watch's scenes, which are asked for again and again.
// Those of an earlier watch may be another grader's.
static void answers_begin(const Watch *watch, const char *name)
{
    char path[PATH_MAX];
    path_make(path, "%s/%s", watch->look.folder, name);
    mkdir(path, 0777);
    path_make(path, "%s/%s/%s", watch->look.folder, name, watch->seed);
    unlink(path);
}

int watch_run(const Desk *desk)
{
    static Watch watch;
    struct termios before;
    sigset_t set;
    watch = (Watch){.desk = desk, .child = {.output = -1}, .start_ms = stats_clock_ms()};
    look_open(desk, &watch.look);
    path_make(watch.results, "%s/grade/%.2s/results.json", desk->build, desk->lab->lab);
    snprintf(watch.seed, sizeof watch.seed, "%ld", 1 + (long)time(NULL) % 99999);
    const int lock = lock_take(&watch);
    if (lock < 0) {
        return -1;
    }
    answers_begin(&watch, "answers");
    answers_begin(&watch, "native-answers");
    watch.news = (News){.look = &watch.look, .said = strdup(""), .changes = strdup("")};
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
        watch_publish(&watch, message_new("the watch has ended; make watch LAB=%.2s goes on",
                                          desk->lab->lab));
    }
    if (watch.has_terminal) {
        tcsetattr(STDIN_FILENO, TCSANOW, &before);
    }
    printf("\nStopped; what was reached is in make progress.\n");
    news_free(&watch.news);
    look_close(&watch.look);
    free(watch.child.said);
    close(signals);
    close(lock);
    return 0;
}
