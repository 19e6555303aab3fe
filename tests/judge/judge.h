// What a lab's judge is made of: a table of its checks, the job that it sets, and what decides each
// check.
//
// The grader runs the same job for the solution and for the submission, and for each task with a
// failed check a job with the answer to that task alone, and asks the judge about each
// (judge_tool.c). One folder a lab: the table `checks` of its judge_NN.c says who decides each
// check. Its points are in the lab's lab.json.
#ifndef JUDGE_JUDGE_H
#define JUDGE_JUDGE_H

#include "function.h"
#include "job_picture.h"
#include "job_sections.h"
#include "random.h"
#include "replay.h"
#include "result.h"
#include "scene_kind.h"
#include "sections.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

struct JobScene;
struct KdTree2D;
struct TreeScene3D;
struct KdTree3D;

// A row of a lab's table. The functions get the lab's own job, which begins with a Job.
typedef struct JudgeCheck {
    const char *id;     // "overlaps-boundary"
    const char *title;  // "Pixels exactly on the boundary"
    const char *task;   // whose answer it judges
    const char *needs;  // whose answers have a part in it besides: see verdict.h

    // One of these decides: a function of the student's over a range of inputs; each scene of a
    // range, of which the first that does not pass is the verdict (judge_scenes() has an
    // exception); the same of each scene's tree, by the property below; or all the answers at
    // once.
    const Function *function;
    Verdict (*scene)(const void *job, int k, const Sections *answers);
    Verdict (*tree)(const void *job, int k, const struct JudgeCheck *check,
                    const Sections *answers);
    Verdict (*all)(const void *job, const Sections *answers);
    Range range;  // of inputs or scenes; none for all
    Diagnosis (*tree2d)(const struct JobScene *scene, const struct KdTree2D *own);     // lab 02
    Diagnosis (*tree3d)(const struct TreeScene3D *scene, const struct KdTree3D *own);  // lab 06

    // The same by what the answer to its task does alone (grader/alone.h): all of it, scene by
    // scene, by every input of some functions, or in a replay. Where none is set, it is judged as
    // in the whole.
    int (*alone)(const void *job, const struct JudgeCheck *check, const Sections *answers);
    int (*alone_scene)(const void *job, int k, const Sections *answers);
    Range alone_range;                   // of scenes; that of the whole where none is set
    const Function *alone_functions[2];  // in the place of whole scenes, which need other tasks
    const Replay *replay;
    // Where stubs have a part in it: the known mistake that explains what one answer did alone,
    // if it is certain; of scenes what they look like. Of functions (alone_functions) it is one of
    // theirs; of the check's own function, where that goes by stubs while the job is_alone, too
    // (judge_function_alone).
    Cause (*alone_cause)(const void *job, const struct JudgeCheck *check, const Sections *answers);
} JudgeCheck;

// A section of the job that lies as an array in the lab's own job. Where each element is one
// function's input the probe notes which one, before it calls the function (probes/note.h): for the
// words that say where a run ended.
typedef struct JobPart {
    const char *section;
    const char *tasks;  // whose functions get it, parted by blanks; NULL for none
    size_t offset, n_bytes;
    size_t input_bytes;  // of an element that is an input; 0 for what inputs refer to
    int is_apart;        // alone a task gets another one, by write_alone
    // The words of one input. NULL on the device, where the words are those in which a check tells
    // a wrong answer to it.
    void (*describe)(const void *input, char *words, size_t n_bytes);
    // What a crash with this input comes from, where the input itself tells; else NULL.
    const char *(*suspect)(const void *input);
} JobPart;
#define DATA(name, who, type, member)                                                              \
    {.section = name,                                                                              \
     .tasks = who,                                                                                 \
     .offset = offsetof(type, member),                                                             \
     .n_bytes = sizeof((type *)0)->member}
#define INPUTS(name, who, type, member, ...)                                                       \
    {.section = name,                                                                              \
     .tasks = who,                                                                                 \
     .offset = offsetof(type, member),                                                             \
     .n_bytes = sizeof((type *)0)->member,                                                         \
     .input_bytes = sizeof *((type *)0)->member,                                                   \
     __VA_ARGS__}

// The scenes of a job: an array in the lab's own.
typedef struct JobScenes {
    const SceneKind *kind;
    int n;
    size_t offset, n_bytes;  // of the first in the job, and of each
} JobScenes;
#define SCENES(kind, type, member)                                                                 \
    {&(kind), COUNT(((type *)0)->member), offsetof(type, member), sizeof *((type *)0)->member}

// What the lab's probe does with a scene, as it notes it by the name of the scene's answers.
typedef struct SceneStep {
    const char *answers;
    const char *where;  // "while kdtree2d_build built a whole tree"
    const char *task;   // whose answer is all that runs there; NULL where several do
} SceneStep;
enum { MOST_SCENE_STEPS = 4 };

typedef struct Judge {
    const char *lab;  // "01-naive-2d"
    const JudgeCheck *checks;
    int n_checks;
    size_t job_bytes;  // of the lab's own job

    // Roll all of the job, which is zeros: choose it at random by the seed, and find out what is
    // expected. Returns 0, or -1 after one message.
    int (*roll)(void *job, Random *random);
    // Release what the job owns besides its scenes; it may be rolled in part. NULL for nothing.
    void (*release)(void *job);

    // The job's file: first the parts, then the scenes. Those that write return 0, or -1.
    const JobPart *parts;
    int n_parts;
    JobScenes scenes;
    SceneStep scene_steps[MOST_SCENE_STEPS];
    // In the place of their kind's, where that does not know all of it.
    int (*write_scene)(const void *job, int k, FILE *file);
    // What one task is tried on alone, besides its parts and replays; NULL for nothing.
    int (*write_alone)(const void *job, const char *task, FILE *file);

    // Are pictures compared with those of the solution, once they are there? Else the oracle's stay
    // the reference: a right solution may be as far from them as ours is, on the other side.
    int adopts;
    // Add pictures for the report; NULL for those of the scenes.
    void (*add_pictures)(const void *job, const Sections *answers, Result *result);
} Judge;

// Those that a program is linked with, NULL behind the last: one in a judge, all in tests
// (judges.c).
extern const Judge *const judges[];

// The judge of a lab by its name, "03-kdtree-2d-render", or its number, "03" or "3"; or NULL.
const Judge *judge_of(const char *lab);

// ---- A job --------------------------------------------------------------------------------------

// What each lab's own job begins with.
typedef struct Job {
    const Judge *judge;
    Growth growth;   // labs 02 and 06: the right trees of the scenes, for replays
    uint32_t nonce;  // of the stubs: nonce.h
    int is_alone;    // the answers are those of one task, beside stubs: see alone_cause
} Job;

// Scene number k, and its picture, which is answered by "picture.K".
const void *job_scene(const void *job, int k);
const JobPicture *job_picture(const void *job, int k);

// Roll a job from the seed and write it as sections. Returns the job, with all that is expected, or
// NULL after one message on stderr.
Job *job_new(const Judge *judge, uint64_t seed, FILE *file);
void job_free(Job *job);

// Write what the probe shall try of one task's answer alone as sections. Returns 0, or -1.
int job_write_alone(const Job *job, const char *task, FILE *file);

// Judge check number `check` by the answers.
Verdict job_judge(const Job *job, int check, const Sections *answers);

// Does check number `check` pass by what the answer to its task does alone?
int job_passes_alone(const Job *job, int check, const Sections *answers);

// Which known mistake explains why check number `check` fails by that: a diagnosis without facts.
// NOTHING_WRONG where none is known, and where stubs have no part in it: then job_judge() says
// it.
Diagnosis job_alone_cause(Job *job, int check, const Sections *answers);

// Where the probe was when it noted this name and a number: of an input, or of a scene.
typedef struct JobPlace {
    char where[100];      // "in split_box"; "" where the lab has nothing of this name
    const char *task;     // whose answer is all that runs there, or NULL
    const char *suspect;  // what a crash there comes from, or NULL
    char with[240];       // "input 17 of 400: box x [0, 4] y [0, 2]", "random scene, 9 circles"
} JobPlace;
// `written` is the job as job_new() has written it.
JobPlace job_place(const Job *job, const Sections *written, const char *name, uint32_t number);

// From now on compare pictures with these, which the solution drew on this device and which have
// just passed every check against the oracle. Never called where there is no solution.
void job_adopt(Job *job, const Sections *answers);

// Add pictures for the report: those that are wrong first.
void job_add_pictures(const Job *job, const Sections *answers, Result *result);

// ---- What tables name ---------------------------------------------------------------------------

// Is the picture of scene K right? Is nothing written outside of it, and everything inside?
Verdict judge_picture(const void *job, int k, const Sections *answers);
Verdict judge_padding(const void *job, int k, const Sections *answers);

// The known mistake of the check's function that explains its range. As alone_cause has it.
Cause judge_function_alone(const void *job, const JudgeCheck *check, const Sections *answers);

#endif
