// The judge of one lab: a function of seed and answers to verdicts and pictures.
//
//     build/judges/NN-name <requests >replies
//
// Its first line is a seed, which no command line shows. It rolls the lab's job from that and then
// answers requests, each a line "WORD ARGUMENT N" with N bytes behind it; each reply is a line "N"
// with N bytes behind it, which are sections (probes/sections.h):
//
//     checks - 0     a section "check" for each, its texts parted by zeros: id, title, task,
//                    whose answers it needs, and 1 where it is of scenes
//     job - 0        what a probe shall try of a submission
//     job TASK 0     what it shall try of one task's answer alone
//     place NAME:I 0 where its probe was when it noted this step and number: sections "where",
//                    "task", "with" and "suspect", each where it is known
//     answers - N    hold these N bytes: what a probe answered. An empty reply, as for adopt
//     verdict I 0    check number I by the answers held: a section "passed", "missing" or "failed",
//                    the last with a SentKinds; and of a failed one "found" and, where it is known,
//                    "cause" (grader/verdict/diagnosis.h)
//     alone I 0      does check number I pass by what one answer did alone? "passed" or "failed"
//     cause I 0      why does it fail by that? As for verdict, but without facts
//     adopt - 0      compare pictures with those held from now on
//     pictures - 0   sections "title", "reference", "own", "svg_reference", "svg_own", of each
//                    picture those that it has, in this order
//
// Exit status: 0 at the end of the requests, 2 after one message on stderr. Started by
// grader/verdict/judge_process.c. Read next: judge.h.
#include "complain.h"
#include "judge.h"
#include "judge_limits.h"
#include "number.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_FAULT = 2 };

typedef struct Desk {
    Job *job;
    char *job_bytes;
    size_t n_job_bytes;
    Sections held;
} Desk;

static int write_reply(const char *bytes, size_t n_bytes)
{
    printf("%zu\n", n_bytes);
    fwrite(bytes, 1, n_bytes, stdout);
    return fflush(stdout) == 0 ? 0 : -1;
}

// ---- Requests -----------------------------------------------------------------------------------

// Each writes the reply's sections to a file. Returns 0, or -1.
typedef int Reply(Desk *desk, const char *argument, FILE *reply);

static int reply_checks(Desk *desk, const char *argument, FILE *reply)
{
    (void)argument;
    int result = 0;
    for (int i = 0; result == 0 && i < desk->job->judge->n_checks; i++) {
        const JudgeCheck *check = &desk->job->judge->checks[i];
        char text[512];
        const int is_same_alone = check->alone == NULL && check->alone_scene == NULL &&
                                  check->alone_functions[0] == NULL && check->replay == NULL;
        const int n = snprintf(text, sizeof text, "%s%c%s%c%s%c%s%c%d%c%d", check->id, 0,
                               check->title, 0, check->task, 0, check->needs ? check->needs : "", 0,
                               check->scene != NULL, 0, is_same_alone);
        result = n < (int)sizeof text ? section_write(reply, "check", text, (size_t)n + 1) : -1;
    }
    return result;
}

static int reply_job(Desk *desk, const char *argument, FILE *reply)
{
    if (strcmp(argument, "-") != 0) {
        return job_write_alone(desk->job, argument, reply);
    }
    return fwrite(desk->job_bytes, 1, desk->n_job_bytes, reply) == desk->n_job_bytes ? 0 : -1;
}

// A text; nothing where there is none.
static int write_text(FILE *reply, const char *name, const char *text)
{
    return text != NULL ? section_write(reply, name, text, strlen(text)) : 0;
}

static int reply_place(Desk *desk, const char *argument, FILE *reply)
{
    char name[SECTION_NAME_BYTES];  // of 23 characters at most, as below
    uint32_t number;
    if (sscanf(argument, "%23[^:]:%" SCNu32, name, &number) != 2) {
        return -1;
    }
    const Sections written = {.bytes = (unsigned char *)desk->job_bytes,
                              .n_bytes = desk->n_job_bytes};
    const JobPlace place = job_place(desk->job, &written, name, number);
    return place.where[0] == '\0'
               ? 0
               : write_text(reply, "where", place.where) | write_text(reply, "task", place.task) |
                     write_text(reply, "with", place.with) |
                     write_text(reply, "suspect", place.suspect);
}

// The number of a check, or -1.
static int read_check(const Desk *desk, const char *argument)
{
    uint64_t number;
    const int n = desk->job->judge->n_checks;
    return number_read_unsigned(argument, 0, (uint64_t)n - 1, &number) == 0 ? (int)number : -1;
}

static int reply_verdict(Desk *desk, const char *argument, FILE *reply)
{
    static const char *const names[] = {
        [VERDICT_PASSED] = "passed", [VERDICT_FAILED] = "failed", [VERDICT_MISSING] = "missing"};
    const int check = read_check(desk, argument);
    if (check < 0) {
        return -1;
    }
    Verdict verdict = job_judge(desk->job, check, &desk->held);
    const Diagnosis *diagnosis = &verdict.diagnosis;
    const SentKinds kinds = {diagnosis->mistake, diagnosis->evidence};
    const size_t n_bytes = verdict.kind == VERDICT_FAILED ? sizeof kinds : 0;
    const int result = section_write(reply, names[verdict.kind], &kinds, n_bytes) |
                       write_text(reply, "found", diagnosis->found) |
                       write_text(reply, "cause", diagnosis->cause);
    diagnosis_free(&verdict.diagnosis);
    return result;
}

static int reply_alone(Desk *desk, const char *argument, FILE *reply)
{
    const int check = read_check(desk, argument);
    if (check < 0) {
        return -1;
    }
    const int passes = job_passes_alone(desk->job, check, &desk->held);
    return section_write(reply, passes ? "passed" : "failed", "", 0);
}

static int reply_cause(Desk *desk, const char *argument, FILE *reply)
{
    const int check = read_check(desk, argument);
    if (check < 0) {
        return -1;
    }
    Diagnosis diagnosis = job_alone_cause(desk->job, check, &desk->held);
    const SentKinds kinds = {diagnosis.mistake, diagnosis.evidence};
    const int result = section_write(reply, "failed", &kinds, sizeof kinds) |
                       write_text(reply, "cause", diagnosis.cause);
    diagnosis_free(&diagnosis);
    return result;
}

static int reply_adopt(Desk *desk, const char *argument, FILE *reply)
{
    (void)argument, (void)reply;
    job_adopt(desk->job, &desk->held);
    return 0;
}

// A picture as its two sides and its pixels; nothing where there is none.
static int write_image(FILE *reply, const char *name, const Image *image)
{
    const size_t n_floats = (size_t)image->width * (size_t)image->height * IMAGE_CHANNELS;
    const int32_t sides[4] = {image->width, image->height};
    char *bytes = malloc(sizeof sides + n_floats * sizeof *image->pixels);
    if (image->width == 0 || bytes == NULL) {
        free(bytes);
        return image->width == 0 ? 0 : -1;
    }
    memcpy(bytes, sides, sizeof sides);
    memcpy(bytes + sizeof sides, image->pixels, n_floats * sizeof *image->pixels);
    const int result =
        section_write(reply, name, bytes, sizeof sides + n_floats * sizeof *image->pixels);
    free(bytes);
    return result;
}

static int reply_pictures(Desk *desk, const char *argument, FILE *reply)
{
    (void)argument;
    static Result result;
    int failed = 0;
    job_add_pictures(desk->job, &desk->held, &result);
    for (int i = 0; !failed && i < result.n_pictures; i++) {
        const PictureResult *picture = &result.pictures[i];
        failed = write_text(reply, "title", picture->title) |
                 write_image(reply, "reference", &picture->reference) |
                 write_image(reply, "own", &picture->own) |
                 write_text(reply, "svg_reference", picture->svg_reference) |
                 write_text(reply, "svg_own", picture->svg_own);
    }
    result_free(&result);
    return failed;
}

// ---- The desk -----------------------------------------------------------------------------------

static const struct {
    const char *word;
    Reply *reply;
} requests[] = {
    {"checks", reply_checks},   {"job", reply_job},           {"place", reply_place},
    {"verdict", reply_verdict}, {"alone", reply_alone},       {"cause", reply_cause},
    {"adopt", reply_adopt},     {"pictures", reply_pictures},
};

// Reply to one request. Returns 0, or -1.
static int serve(Desk *desk, const char *word, const char *argument)
{
    for (size_t i = 0; i < sizeof requests / sizeof *requests; i++) {
        if (strcmp(requests[i].word, word) != 0) {
            continue;
        }
        char *bytes = NULL;
        size_t n_bytes = 0;
        FILE *reply = open_memstream(&bytes, &n_bytes);
        int result = reply != NULL ? requests[i].reply(desk, argument, reply) : -1;
        if (reply == NULL || fclose(reply) != 0 || result != 0) {
            complain("judge: no reply to \"%s %s\"", word, argument);
            result = -1;
        }
        result = result == 0 ? write_reply(bytes, n_bytes) : -1;
        free(bytes);
        return result;
    }
    complain("judge: found the request \"%s\", expected one that is known", word);
    return -1;
}

// Is it about the answers that are held? All that is asked of them is limited together.
static int is_about_answers(const char *word)
{
    return strcmp(word, "verdict") == 0 || strcmp(word, "alone") == 0 ||
           strcmp(word, "cause") == 0 || strcmp(word, "pictures") == 0;
}

// Reply to what is asked until nothing is. Returns an exit status.
static int serve_all(Desk *desk)
{
    char line[128], word[16], argument[64];
    size_t n_bytes;
    while (fgets(line, sizeof line, stdin) != NULL) {
        if (sscanf(line, "%15s %63s %zu", word, argument, &n_bytes) != 3) {
            complain("judge: a request that is no word, argument and number");
            return EXIT_FAULT;
        }
        if (!is_about_answers(word)) {
            limit_time(MOST_SECONDS);
        }
        if (strcmp(word, "answers") == 0) {
            sections_free(&desk->held);
            if (sections_read(stdin, n_bytes, &desk->held) != 0 || write_reply("", 0) != 0) {
                complain("judge: answers that end too soon");
                return EXIT_FAULT;
            }
        } else if (serve(desk, word, argument) != 0) {
            return EXIT_FAULT;
        }
    }
    return EXIT_SUCCESS;
}

// The first line. Returns 0, or -1.
static int read_seed(uint64_t *seed)
{
    char line[32] = "";
    if (fgets(line, sizeof line, stdin) == NULL) {
        return -1;
    }
    line[strcspn(line, "\n")] = '\0';
    return number_read_unsigned(line, 0, UINT64_MAX, seed);
}

int main(void)
{
    Desk desk = {0};
    uint64_t seed;
    if (read_seed(&seed) != 0) {
        complain("judge: expected a seed as the first line");
        return EXIT_FAULT;
    }
    limit_memory(MOST_BYTES);
    FILE *job = open_memstream(&desk.job_bytes, &desk.n_job_bytes);
    desk.job = job != NULL ? job_new(judges[0], seed, job) : NULL;
    if (job == NULL || fclose(job) != 0 || desk.job == NULL) {
        return EXIT_FAULT;
    }
    const int status = serve_all(&desk);
    job_free(desk.job);
    sections_free(&desk.held);
    free(desk.job_bytes);
    return status;
}
