// What a judge found wrong, as a value: the facts, what they look like, and of which kind the
// mistake is.
//
// Made by the judges (tests/judge/), sent to the grader as it is (judge_process.h), and read by all
// that decide by it: blame.h, advice.h, the hints, the mutants. Nobody looks for anything
// in the sentence that a student reads: diagnosis_text() is where that is made.
#ifndef GRADER_DIAGNOSIS_H
#define GRADER_DIAGNOSIS_H

// The kinds of mistakes that a report must be able to name (tests/known/README.md).
typedef enum Mistake {
    MISTAKE_NONE,  // of none of these kinds, or not recognised
    MISTAKE_MIRRORED_X,
    MISTAKE_FLIPPED_Y,
    MISTAKE_TRANSPOSED,
    MISTAKE_CHANNELS_SWAPPED,
    MISTAKE_SHIFTED_ONE,
    MISTAKE_SHIFTED_HALF,
    MISTAKE_GAMMA,
    MISTAKE_STRICT_BOUNDARY,
    MISTAKE_LATER_OF_EQUALS,
    MISTAKE_FAR_CHILD,
    MISTAKE_MISSING_IN_CELL,
    MISTAKE_UNWRITTEN,
    N_MISTAKES,
} Mistake;

// The kind's name, "flipped-y".
const char *mistake_name(Mistake mistake);

// The kind of this name, or MISTAKE_NONE.
Mistake mistake_find(const char *name);

// In what it was found.
typedef enum Evidence {
    EVIDENCE_VALUES,   // what a function returned, a tree, counted work
    EVIDENCE_RAYS,     // what the rays of a scene hit
    EVIDENCE_PICTURE,  // pixels of a picture differ from what they should be
    // The same of a picture that says enough, though not why: it is empty, of one colour, infinite.
    EVIDENCE_PLAIN_PICTURE,
    N_EVIDENCES,
} Evidence;

// Why nothing is said about the answer itself.
typedef enum Silence {
    SILENCE_NONE,        // it is
    SILENCE_UNANSWERED,  // its task stands as it was handed out
    SILENCE_UNTRIED,     // it could not be tried: its file could not be used, does not compile, ...
    SILENCE_ENDED,       // the program had ended, as the stage "Running" says already
    N_SILENCES,
} Silence;

// "unanswered", "untried" or "ended"; NULL: something is said.
const char *silence_name(Silence silence);

// What wrong answers look like, "the shorter side was split". As judges know it beforehand.
typedef struct Cause {
    const char *says;  // NULL: nothing is known, or the facts say it already
    Mistake mistake;
} Cause;

typedef struct Diagnosis {
    char *found;  // what was found and where, "pixel (3, 4): found 0, expected 1"; NULL: nothing is
                  // wrong. Owned
    char *cause;  // what it looks like, or NULL. Owned
    const char *rule;  // the known mistake that the cause was made of: its Cause.says, or NULL
    Mistake mistake;
    Evidence evidence;
    Silence silence;
} Diagnosis;

#define NOTHING_WRONG ((Diagnosis){0})

// What was found, made like printf makes it, and nothing else. Running out of memory ends the
// program, here and below.
__attribute__((format(printf, 1, 2))) Diagnosis diagnosis_new(const char *format, ...);

// The same where nothing is said about the answer.
__attribute__((format(printf, 2, 3))) Diagnosis diagnosis_silent(Silence silence,
                                                                 const char *format, ...);

// What was found, with what it looks like. Takes `found` over.
Diagnosis diagnosis_of(char *found, Cause cause);

// The same of what was seen in a scene: the cause is "it looks ..." as `looks` says, which stays.
Diagnosis diagnosis_seen(char *found, Cause looks, Evidence evidence);

// The diagnosis with where it was found before it: "random scene: pixel (3, 4): ...". Takes it
// over; where nothing is wrong it stays so.
Diagnosis diagnosis_at(const char *where, Diagnosis diagnosis);

// The sentence for a student: "found 1, expected 0; the shorter side was split". "" where nothing
// is wrong. Owned by the caller.
char *diagnosis_text(const Diagnosis *diagnosis);

void diagnosis_free(Diagnosis *diagnosis);

#endif
