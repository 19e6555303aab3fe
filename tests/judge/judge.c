// What is the same in all judges: rolling and writing a job, and asking whatever a check's row
// names.
#include "judge.h"

#include "complain.h"
#include "nonce.h"
#include "number.h"
#include "one_way.h"
#include "picture_looks.h"

#include <stdlib.h>
#include <string.h>

const Judge *judge_of(const char *lab)
{
    uint64_t number;
    const int is_number = number_read_unsigned(lab, 0, 99, &number) == 0;
    for (const Judge *const *judge = judges; *judge != NULL; judge++) {
        const char *name = (*judge)->lab;
        if (is_number ? strtoul(name, NULL, 10) == number : strcmp(name, lab) == 0) {
            return *judge;
        }
    }
    return NULL;
}

// ---- Rolling and writing ------------------------------------------------------------------------

// Scene number k, to be changed by who may change the job.
static void *scene_of(const void *pointer, int k)
{
    const Job *job = pointer;
    const JobScenes *scenes = &job->judge->scenes;
    return (char *)job + scenes->offset + (size_t)k * scenes->n_bytes;
}

const void *job_scene(const void *job, int k)
{
    return scene_of(job, k);
}

static JobPicture *picture_of(const void *pointer, int k)
{
    const Job *job = pointer;
    return (JobPicture *)((char *)scene_of(job, k) + job->judge->scenes.kind->picture);
}

const JobPicture *job_picture(const void *job, int k)
{
    return picture_of(job, k);
}

// Is the task among those that the text names? NULL names none.
static int is_among(const char *tasks, const char *task)
{
    const size_t n = strlen(task);
    for (const char *at = tasks; at != NULL && *at != '\0'; at += strspn(at, " ")) {
        const size_t length = strcspn(at, " ");
        if (length == n && memcmp(at, task, n) == 0) {
            return 1;
        }
        at += length;
    }
    return 0;
}

// Write the parts for a task alone, or all of them where it is NULL. Returns 0, or -1.
static int write_parts(const Job *job, const char *task, FILE *file)
{
    int result = 0;
    for (int i = 0; result == 0 && i < job->judge->n_parts; i++) {
        const JobPart *part = &job->judge->parts[i];
        if (task == NULL || (!part->is_apart && is_among(part->tasks, task))) {
            result =
                section_write(file, part->section, (const char *)job + part->offset, part->n_bytes);
        }
    }
    return result;
}

Job *job_new(const Judge *judge, uint64_t seed, FILE *file)
{
    Random random = {one_way(seed, PURPOSE_INPUTS)};
    Job *job = calloc(1, judge->job_bytes);
    if (job == NULL) {
        complain("grade: no memory for a job");
        return NULL;
    }
    job->judge = judge;
    job->nonce = stub_nonce(seed);
    int result = judge->roll(job, &random);
    if (result == 0) {
        result = write_parts(job, NULL, file);
    }
    for (int k = 0; result == 0 && k < judge->scenes.n; k++) {
        result = judge->write_scene != NULL ? judge->write_scene(job, k, file)
                                            : judge->scenes.kind->write(job_scene(job, k), k, file);
    }
    if (result != 0) {
        job_free(job);
        return NULL;
    }
    return job;
}

void job_free(Job *job)
{
    for (int k = 0; k < job->judge->scenes.n; k++) {
        job->judge->scenes.kind->release(scene_of(job, k));
    }
    if (job->judge->release != NULL) {
        job->judge->release(job);
    }
    growth_free(&job->growth);
    free(job);
}

int job_write_alone(const Job *job, const char *task, FILE *file)
{
    const Judge *judge = job->judge;
    int result = write_parts(job, task, file);
    for (int i = 0; result == 0 && i < judge->n_checks; i++) {
        const JudgeCheck *check = &judge->checks[i];
        if (check->replay != NULL && strcmp(check->task, task) == 0) {
            result = replay_write(check->replay, &job->growth, job, file);
        }
    }
    return result == 0 && judge->write_alone != NULL ? judge->write_alone(job, task, file) : result;
}

// ---- Judging ------------------------------------------------------------------------------------

// May another scene say more? An empty picture, or one of a single colour, has many causes.
static int is_plain(Verdict verdict)
{
    return verdict.kind == VERDICT_FAILED && verdict.diagnosis.cause == NULL &&
           verdict.diagnosis.evidence == EVIDENCE_PLAIN_PICTURE;
}

// The first scene that does not pass; if its picture is plain, the first of which more is known.
static Verdict judge_scenes(const Job *job, const JudgeCheck *check, const Sections *answers)
{
    Verdict verdict = verdict_passed;
    for (int i = 0; (verdict.kind == VERDICT_PASSED || is_plain(verdict)) && i < check->range.n;
         i++) {
        const int k = range_at(check->range, i);
        Verdict next = check->tree != NULL ? check->tree(job, k, check, answers)
                                           : check->scene(job, k, answers);
        if (verdict.kind == VERDICT_PASSED || next.diagnosis.cause != NULL) {
            diagnosis_free(&verdict.diagnosis);
            verdict = next;
        } else {
            diagnosis_free(&next.diagnosis);
        }
    }
    return verdict;
}

// Is a mistake that a check names contradicted by the first wrong picture of another check of the
// task? Then it is not what the task's answer does.
static int is_contradicted(const Job *job, const JudgeCheck *check, const char *rule,
                           const Sections *answers)
{
    for (int i = 0; i < job->judge->n_checks; i++) {
        const JudgeCheck *other = &job->judge->checks[i];
        int is_right = other != check && other->scene == judge_picture &&
                       strcmp(other->task, check->task) == 0;
        for (int j = 0; is_right && j < other->range.n; j++) {
            const int k = range_at(other->range, j);
            const JobPicture *picture = job_picture(job, k);
            const ProbeImage own = job_picture_answer(picture, k, answers);
            is_right = own.pixels != NULL && picture_is_right(own, &picture->expected);
            if (!is_right && own.pixels && !picture_may_look(own, &picture->expected, rule)) {
                return 1;
            }
        }
    }
    return 0;
}

static Verdict judge_pictures(const Job *job, const JudgeCheck *check, const Sections *answers)
{
    Verdict verdict = judge_scenes(job, check, answers);
    Diagnosis *diagnosis = &verdict.diagnosis;
    if (diagnosis->rule != NULL && is_contradicted(job, check, diagnosis->rule, answers)) {
        free(diagnosis->cause);
        diagnosis->cause = NULL;
        diagnosis->mistake = MISTAKE_NONE;
    }
    return verdict;
}

Verdict job_judge(const Job *job, int number, const Sections *answers)
{
    const JudgeCheck *check = &job->judge->checks[number];
    return check->function != NULL ? function_judge(check->function, job, check->range, answers)
           : check->all != NULL    ? check->all(job, answers)
           : check->scene == judge_picture ? judge_pictures(job, check, answers)
                                           : judge_scenes(job, check, answers);
}

// Are the answers to every input of the functions right?
static int functions_pass(const Function *const functions[2], const Job *job,
                          const Sections *answers)
{
    int passes = 1;
    for (int i = 0; passes && i < 2 && functions[i] != NULL; i++) {
        const Range all = {.n = functions[i]->n};
        passes = verdict_passes(function_judge(functions[i], job, all, answers));
    }
    return passes;
}

int job_passes_alone(const Job *job, int number, const Sections *answers)
{
    const JudgeCheck *check = &job->judge->checks[number];
    if (check->alone != NULL) {
        return check->alone(job, check, answers);
    }
    if (check->alone_functions[0] != NULL) {
        return functions_pass(check->alone_functions, job, answers);
    }
    if (check->replay != NULL) {
        return replay_is_right(check->replay, &job->growth, job, answers);
    }
    if (check->alone_scene == NULL) {
        return verdict_passes(job_judge(job, number, answers));
    }
    const Range range = check->alone_range.n > 0 ? check->alone_range : check->range;
    int passes = 1;
    for (int i = 0; passes && i < range.n; i++) {
        passes = check->alone_scene(job, range_at(range, i), answers);
    }
    return passes;
}

// The first known mistake that explains all answers to one of the functions.
static Cause functions_cause(const Function *const functions[2], const Job *job,
                             const Sections *answers)
{
    Cause cause = {0};
    for (int i = 0; cause.says == NULL && i < 2 && functions[i] != NULL; i++) {
        cause = function_cause(functions[i], job, (Range){.n = functions[i]->n}, answers);
    }
    return cause;
}

Cause judge_function_alone(const void *job, const JudgeCheck *check, const Sections *answers)
{
    return function_cause(check->function, job, check->range, answers);
}

Diagnosis job_alone_cause(Job *job, int number, const Sections *answers)
{
    const JudgeCheck *check = &job->judge->checks[number];
    if (check->alone_cause == NULL) {
        return diagnosis_of(NULL, functions_cause(check->alone_functions, job, answers));
    }
    job->is_alone = 1;
    const Cause cause = check->alone_cause(job, check, answers);
    job->is_alone = 0;
    return check->scene != NULL ? diagnosis_seen(NULL, cause, EVIDENCE_PICTURE)
                                : diagnosis_of(NULL, cause);
}

// ---- Pictures -----------------------------------------------------------------------------------

Verdict judge_picture(const void *job, int k, const Sections *answers)
{
    return job_picture_judge(job_picture(job, k), k, answers);
}

Verdict judge_padding(const void *job, int k, const Sections *answers)
{
    return job_picture_judge_padding(job_picture(job, k), k, answers);
}

void job_adopt(Job *job, const Sections *answers)
{
    for (int k = 0; job->judge->adopts && k < job->judge->scenes.n; k++) {
        job_picture_adopt(picture_of(job, k), k, answers);
    }
}

void job_add_pictures(const Job *job, const Sections *answers, Result *result)
{
    if (job->judge->add_pictures != NULL) {
        job->judge->add_pictures(job, answers, result);
    } else {
        const JobScenes *scenes = &job->judge->scenes;
        job_pictures_report(job_picture(job, 0), scenes->n_bytes, scenes->n, answers, result);
    }
}
