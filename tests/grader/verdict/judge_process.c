// Asking the judge (see judge_process.h).
//
// Called by session.c. Its other end: tests/judge/judge_tool.c, where the requests are listed.
#include "judge_process.h"

#include "complain.h"
#include "message.h"
#include "path.h"

#include <errno.h>
#include <inttypes.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

// A reply holds pictures at most: a dozen, three times each.
#define MOST_REPLY_BYTES ((size_t)1 << 30)

// ---- The process --------------------------------------------------------------------------------

// Start the program with one end of a socket as its standard input and output. Returns 0, or -1
// after one message.
static int spawn(JudgeProcess *judge)
{
    char program[PATH_MAX];
    int ends[2];
    posix_spawn_file_actions_t actions;
    path_make(program, "%s/judges/%s", judge->build, judge->manifest->lab);
    char *const argv[] = {program, NULL};
    char *const environment[] = {NULL};  // nothing of the grader's decides how it computes
    // Closed in every other program that is started.
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        complain("grade: no socket for the judge: %s", strerror(errno));
        return -1;
    }
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    const int error = posix_spawn(&judge->pid, program, &actions, NULL, argv, environment);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    judge->replies = error == 0 ? fdopen(ends[0], "r") : NULL;
    if (judge->replies == NULL) {
        complain("grade: %s: cannot be started: %s; run make grader in the course's top folder",
                 program, strerror(error != 0 ? error : errno));
        close(ends[0]);
        judge->pid = 0;
        return -1;
    }
    judge->held = 0;
    return 0;
}

// Returns the processor time that it has used, in seconds.
//   status   out: as wait4() has it; may be NULL
static double end(JudgeProcess *judge, int *status)
{
    struct rusage used = {0};
    if (judge->pid != 0) {
        fclose(judge->replies);  // it reads that nothing more is asked
        wait4(judge->pid, status, 0, &used);
    }
    judge->pid = 0;
    return (double)used.ru_utime.tv_sec + 1e-6 * (double)used.ru_utime.tv_usec;
}

void judge_stop(JudgeProcess *judge)
{
    end(judge, NULL);
    sections_free(&judge->table);
    *judge = (JudgeProcess){0};
}

// ---- Requests and replies -----------------------------------------------------------------------

// Send all of it, without a signal where nobody is there any more. Returns 0, or -1.
static int send_all(int socket, const void *bytes, size_t n_bytes)
{
    for (size_t n_sent = 0; n_sent < n_bytes;) {
        const ssize_t n =
            send(socket, (const char *)bytes + n_sent, n_bytes - n_sent, MSG_NOSIGNAL);
        if (n < 0 && errno != EINTR) {
            return -1;
        }
        n_sent += n > 0 ? (size_t)n : 0;
    }
    return 0;
}

// Start it, and tell it the seed: not in its command line, which every process of the machine may
// read. Returns 0, or -1 after one message.
static int start(JudgeProcess *judge)
{
    char seed[24];
    if (spawn(judge) != 0) {
        return -1;
    }
    const int n = snprintf(seed, sizeof seed, "%" PRIu64 "\n", judge->seed);
    send_all(fileno(judge->replies), seed, (size_t)n);  // else there is no reply to what follows
    return 0;
}

// Ask, and read the reply. Returns 0, or -1 without a message: the judge has ended.
static int ask(JudgeProcess *judge, const char *word, const char *argument,
               const Sections *contents, Sections *reply)
{
    char line[128];
    size_t n_bytes = contents != NULL ? contents->n_bytes : 0;
    *reply = (Sections){0};
    if (judge->pid == 0) {
        return -1;
    }
    const int socket = fileno(judge->replies);
    const int n = snprintf(line, sizeof line, "%s %s %zu\n", word, argument, n_bytes);
    if (send_all(socket, line, (size_t)n) != 0 ||
        (n_bytes > 0 && send_all(socket, contents->bytes, n_bytes) != 0) ||
        fscanf(judge->replies, "%zu", &n_bytes) != 1 || fgetc(judge->replies) != '\n' ||
        n_bytes > MOST_REPLY_BYTES) {
        return -1;
    }
    return sections_read(judge->replies, n_bytes, reply);
}

// Let it hold these answers. Returns 0, or -1 without a message.
static int hold(JudgeProcess *judge, Answers answers)
{
    Sections reply;
    if (judge->held == answers.number) {
        return 0;
    }
    judge->held = 0;
    const int result = ask(judge, "answers", "-", answers.sections, &reply);
    sections_free(&reply);
    judge->held = result == 0 ? answers.number : 0;
    return result;
}

static int adopt(JudgeProcess *judge)
{
    Sections reply;
    const int result = hold(judge, judge->adopted) | ask(judge, "adopt", "-", NULL, &reply);
    sections_free(&reply);
    return result;
}

// Start the judge anew. Returns 0, or -1 after one message.
static int restart(JudgeProcess *judge)
{
    judge->lost_seconds += end(judge, NULL);
    const int result = start(judge);
    if (result == 0 && judge->adopted.number != 0) {
        adopt(judge);
    }
    return result;
}

// Ask about a submission's answers. Where the judge ends over them it is started anew, and they are
// not judged again. Returns 0, or -1 without a message.
static int ask_about(JudgeProcess *judge, Answers answers, const char *word, const char *argument,
                     Sections *reply)
{
    *reply = (Sections){0};
    if (judge->unjudged == answers.number) {
        return -1;
    }
    if (hold(judge, answers) == 0 && ask(judge, word, argument, NULL, reply) == 0) {
        return 0;
    }
    judge->unjudged = answers.number;
    restart(judge);
    return -1;
}

// ---- What is asked ------------------------------------------------------------------------------

// The next of several texts that zeros part.
static const char *next_text(const char **place, const char *end)
{
    const char *text = *place;
    *place += strnlen(text, (size_t)(end - text));
    *place += *place < end;
    return text;
}

// Read the lab's checks. Returns 0, or -1 after one message.
static int read_checks(JudgeProcess *judge)
{
    const char *name, *bytes;
    size_t place = 0, n_bytes;
    if (ask(judge, "checks", "-", NULL, &judge->table) != 0) {
        int status = 0;
        end(judge, &status);
        if (WIFSIGNALED(status)) {  // else it has said why
            complain("grade: the judge was ended by signal %d before it named its checks",
                     WTERMSIG(status));
        }
        return -1;
    }
    while ((bytes = sections_next(&judge->table, &place, &name, &n_bytes)) != NULL &&
           judge->n_checks < RESULT_MAX_CHECKS) {
        const char *const end = bytes + n_bytes;
        Check *check = &judge->checks[judge->n_checks++];
        check->id = next_text(&bytes, end);
        check->title = next_text(&bytes, end);
        check->task = next_text(&bytes, end);
        check->needs = next_text(&bytes, end);
        check->is_of_scenes = atoi(next_text(&bytes, end));
        check->is_same_alone = atoi(next_text(&bytes, end));
    }
    return 0;
}

static Check *find_check(JudgeProcess *judge, const char *task, const char *id)
{
    for (int i = 0; i < judge->n_checks; i++) {
        Check *check = &judge->checks[i];
        if (strcmp(check->task, task) == 0 && strcmp(check->id, id) == 0) {
            return check;
        }
    }
    return NULL;
}

// Give each check the points of the manifest, which has those checks and no other. Returns 0, or -1
// after one message.
static int take_points(JudgeProcess *judge)
{
    const Manifest *manifest = judge->manifest;
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        for (int i = 0; i < task->n_checks; i++) {
            Check *check = find_check(judge, task->id, task->checks[i].id);
            if (check == NULL) {
                complain("%s/%s/lab.json: %s: found points for \"%s\", which is no check of this "
                         "task; its checks are in tests/judge/%s",
                         manifest_folder(manifest->lab), manifest->lab, task->id,
                         task->checks[i].id, manifest->lab);
                return -1;
            }
            check->points = task->checks[i].points;
        }
    }
    for (int i = 0; i < judge->n_checks; i++) {
        const Check *check = &judge->checks[i];
        if (manifest_check(manifest, check->id) == NULL) {
            complain("%s/%s/lab.json: %s: found no points for the check \"%s\"",
                     manifest_folder(manifest->lab), manifest->lab, check->task, check->id);
            return -1;
        }
    }
    return 0;
}

int judge_start(JudgeProcess *judge, const char *build, const Manifest *manifest, uint64_t seed)
{
    *judge = (JudgeProcess){.build = build, .manifest = manifest, .seed = seed};
    return start(judge) != 0 || read_checks(judge) != 0 ? -1 : take_points(judge);
}

int judge_job(JudgeProcess *judge, const char *task, FILE *file)
{
    Sections job;
    const char *argument = task != NULL ? task : "-";
    int result = ask(judge, "job", argument, NULL, &job);
    // Answers that it holds may have left it without memory for more: that is no fault of ours.
    if (result != 0 && restart(judge) == 0) {
        result = ask(judge, "job", argument, NULL, &job);
    }
    if (result != 0) {
        complain("grade: the judge gave no job");
    } else if (fwrite(job.bytes, 1, job.n_bytes, file) != job.n_bytes) {
        complain("grade: a job cannot be written: %s", strerror(errno));
        result = -1;
    }
    sections_free(&job);
    return result;
}

// A text of a reply, NULL where there is none. Owned by the caller.
static char *read_text(const Sections *reply, const char *name)
{
    size_t n_bytes;
    const char *text = sections_find_any(reply, name, &n_bytes);
    return text != NULL ? message_new("%.*s", (int)n_bytes, text) : NULL;
}

static void copy_text(const Sections *reply, const char *name, char *text, size_t n_text)
{
    size_t n_bytes;
    const char *found = sections_find_any(reply, name, &n_bytes);
    snprintf(text, n_text, "%.*s", found != NULL ? (int)n_bytes : 0, found != NULL ? found : "");
}

RunPlace judge_place(JudgeProcess *judge, const ProbeNote *note)
{
    RunPlace place = {0};
    Sections reply = {0};
    char argument[SECTION_NAME_BYTES + 16];
    snprintf(argument, sizeof argument, "%s:%" PRIu32, note->name, note->input);
    if (run_note_is_name(note) && ask(judge, "place", argument, NULL, &reply) == 0) {
        copy_text(&reply, "where", place.where, sizeof place.where);
        copy_text(&reply, "task", place.task, sizeof place.task);
        copy_text(&reply, "with", place.with, sizeof place.with);
        copy_text(&reply, "suspect", place.suspect, sizeof place.suspect);
    }
    sections_free(&reply);
    return place;
}

static Verdict read_verdict(const Sections *reply)
{
    const SentKinds *kinds = sections_find(reply, "failed", sizeof *kinds);
    if (kinds != NULL && kinds->mistake < N_MISTAKES && kinds->evidence < N_EVIDENCES) {
        return (Verdict){VERDICT_FAILED,
                         {.found = read_text(reply, "found"),
                          .cause = read_text(reply, "cause"),
                          .mistake = (Mistake)kinds->mistake,
                          .evidence = (Evidence)kinds->evidence}};
    }
    return (Verdict){.kind = sections_find(reply, "passed", 0) != NULL ? VERDICT_PASSED
                                                                       : VERDICT_MISSING};
}

Verdict judge_verdict(JudgeProcess *judge, Answers answers, int check)
{
    Sections reply;
    char number[16];
    snprintf(number, sizeof number, "%d", check);
    if (ask_about(judge, answers, "verdict", number, &reply) != 0) {
        return (Verdict){VERDICT_FAILED,
                         diagnosis_new("the answers cannot be judged: no probe writes such ones")};
    }
    const Verdict verdict = read_verdict(&reply);
    sections_free(&reply);
    return verdict;
}

int judge_passes_alone(JudgeProcess *judge, Answers answers, int check)
{
    Sections reply;
    char number[16];
    snprintf(number, sizeof number, "%d", check);
    const int passes = ask_about(judge, answers, "alone", number, &reply) == 0 &&
                       sections_find(&reply, "passed", 0) != NULL;
    sections_free(&reply);
    return passes;
}

Diagnosis judge_alone_cause(JudgeProcess *judge, Answers answers, int check)
{
    Sections reply;
    char number[16];
    Verdict verdict = {.diagnosis = NOTHING_WRONG};
    snprintf(number, sizeof number, "%d", check);
    if (ask_about(judge, answers, "cause", number, &reply) == 0) {
        verdict = read_verdict(&reply);
    }
    sections_free(&reply);
    return verdict.diagnosis;
}

int judge_adopt(JudgeProcess *judge, Answers answers)
{
    judge->adopted = answers;
    if (adopt(judge) != 0) {
        complain("grade: the judge ended over the solution's answers");
        return -1;
    }
    return 0;
}

// ---- Pictures -----------------------------------------------------------------------------------

// A picture from its two sides and its pixels. Returns 0, or -1 after one message.
static int read_image(const void *bytes, size_t n_bytes, Image *image)
{
    int32_t sides[4];
    if (n_bytes < sizeof sides) {
        return -1;
    }
    memcpy(sides, bytes, sizeof sides);
    const size_t n_floats = (size_t)sides[0] * (size_t)sides[1] * IMAGE_CHANNELS;
    if (n_bytes != sizeof sides + n_floats * sizeof(float) ||
        image_create(sides[0], sides[1], image) != 0) {
        return -1;
    }
    memcpy(image->pixels, (const char *)bytes + sizeof sides, n_floats * sizeof(float));
    return 0;
}

// Take a section of a picture in. Returns 0, or -1.
static int read_part(const char *name, const char *bytes, size_t n_bytes, PictureResult *picture)
{
    if (strcmp(name, "reference") == 0 || strcmp(name, "own") == 0) {
        return read_image(bytes, n_bytes, name[0] == 'o' ? &picture->own : &picture->reference);
    }
    char **text = strcmp(name, "svg_own") == 0 ? &picture->svg_own : &picture->svg_reference;
    *text = strndup(bytes, n_bytes);
    return *text != NULL ? 0 : -1;
}

int judge_add_pictures(JudgeProcess *judge, Answers answers, Result *result)
{
    Sections reply;
    const char *name, *bytes;
    size_t place = 0, n_bytes;
    int failed = 0;
    if (ask_about(judge, answers, "pictures", "-", &reply) != 0) {
        return 0;  // that they cannot be judged is reported already
    }
    while (!failed && (bytes = sections_next(&reply, &place, &name, &n_bytes)) != NULL) {
        if (strcmp(name, "title") != 0) {
            failed = result->n_pictures == 0 ||
                     read_part(name, bytes, n_bytes, &result->pictures[result->n_pictures - 1]);
        } else if (result->n_pictures < RESULT_MAX_PICTURES) {
            PictureResult *picture = &result->pictures[result->n_pictures++];
            snprintf(picture->title, sizeof picture->title, "%.*s", (int)n_bytes, bytes);
        }
    }
    sections_free(&reply);
    if (failed) {
        complain("grade: no memory for the pictures");
    }
    return failed ? -1 : 0;
}
