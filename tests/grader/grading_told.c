// Saying what came of an answer that was tried alone (see grading.h).
//
// Called by grading_alone.c. What a run alone found stays inside where stubs have a part in it.
#include "blame.h"
#include "grading.h"
#include "message.h"
#include "source_words.h"

#include <stdlib.h>
#include <string.h>

// Does the answer name another task, or make names by # or ##, in a macro of its own? Then a
// stub may have had a part in what was found alone.
static int names_others(const Grading *grading, int t)
{
    char *answer = grading_answer(grading, &grading->session.manifest.tasks[t]);
    int n_named = answer == NULL;
    SourceReader reader = source_reader(answer != NULL ? answer : "");
    for (SourceWord word = source_next(&reader); word.kind != SOURCE_END;
         word = source_next(&reader)) {
        n_named +=
            word.in_directive && !word.begins_directive && source_is(&word, SOURCE_SIGN, "#");
        for (int other = 0; other < grading->session.manifest.n_tasks; other++) {
            n_named += other != t &&
                       source_is(&word, SOURCE_NAME, grading->session.manifest.tasks[other].id);
        }
    }
    free(answer);
    return n_named > 0;
}

// Let a check fail with what was found alone.
static void tell(CheckResult *check, Diagnosis diagnosis, int is_explained)
{
    check_fail(check, diagnosis);
    check->is_explained = is_explained;
    check->is_told_alone = 1;
}

// Behind what was found in the whole, if anything was. Takes the text over.
static char *found_and(const CheckResult *check, char *alone)
{
    if (check->status != CHECK_FAILED) {
        return alone;
    }
    char *both = message_new("%s; %s", check->diagnosis.found, alone);
    free(alone);
    return both;
}

// Say what was found. Only where the check is judged alone as in the whole, on the same inputs and
// by the lab's rules, and where the answer calls no other task's function: what stubs do has no
// part in what is said. Returns whether there was anything to say.
static int tell_found(Grading *grading, int t, int i)
{
    CheckResult *check = &grading->result.checks[i];
    CheckResult found = {.max_points = check->max_points};
    check_tell(&found, NOTHING_WRONG);
    if (grading->session.judge.checks[i].is_same_alone && !names_others(grading, t)) {
        session_judge(&grading->session, 0, i, &grading->alone[t], &found);
    }
    const Diagnosis *own = &found.diagnosis;
    const int is_told = found.status == CHECK_FAILED;
    if (is_told) {
        tell(check,
             (Diagnosis){.found = message_new("tested alone: %s", own->found),
                         .cause = own->cause ? message_new("%s", own->cause) : NULL,
                         .mistake = own->mistake,
                         .evidence = own->evidence,
                         .silence = own->silence},
             found.is_explained);
    }
    check_free(&found);
    return is_told;
}

// Say by which known mistake it fails, where stubs have a part in that: what was found would
// show what they do, a sentence of ours does not. The facts stay those of the whole. Returns
// whether there was anything to say.
static int tell_cause(Grading *grading, int t, int i)
{
    CheckResult *check = &grading->result.checks[i];
    Diagnosis alone =
        judge_alone_cause(&grading->session.judge, variant_answers(&grading->alone[t]), i);
    const int is_told = alone.cause != NULL;
    if (is_told) {
        const char *found =
            check->status == CHECK_FAILED ? check->diagnosis.found : "it fails when tested alone";
        tell(check,
             (Diagnosis){.found = message_new("%s", found),
                         .cause = message_new("tested alone: %s", alone.cause),
                         .mistake = alone.mistake,
                         .evidence = check->diagnosis.evidence},
             1);
    }
    diagnosis_free(&alone);
    return is_told;
}

// Say that its answer does not come to its end, which is its own mistake whatever else is wrong.
// How it ended is said only as far as a run cannot choose among many ways: by an exit status it
// could tell what stubs hold.
static void tell_end(CheckResult *check, const Variant *alone)
{
    const char *end = alone->is_endless    ? alone->trouble
                      : alone->has_crashed ? "it crashes; an index or a pointer out of range?"
                                           : "it does not come to its end";
    tell(check,
         (Diagnosis){.found = found_and(check, message_new("tested alone, %s", end)),
                     .evidence = check->diagnosis.evidence},
         alone->is_endless || alone->has_crashed);
}

// Say that it does not compile, by which macro if it may lack one that is defined elsewhere.
static void tell_lack(const Grading *grading, int t, CheckResult *check)
{
    // The macro's name is the student's own text, and a cause stands on pages that have none of it
    // (class_page.h).
    char *macro = grading_lacked_macro(grading, t);
    if (macro != NULL) {
        tell(check,
             (Diagnosis){.found = found_and(check, message_new("without your other answers it does "
                                                               "not compile: it uses the macro %s",
                                                               macro)),
                         .cause = message_new("it uses a macro that is not defined between its own "
                                              "markers"),
                         .evidence = check->diagnosis.evidence},
             1);
    } else {
        // What does not compile is reported once, under "Compiling".
        check->alone = "without your other answers it does not compile, so it was not tested alone";
    }
    free(macro);
}

void grading_tell_alone(Grading *grading, int t, int i, int is_others)
{
    const Variant *alone = &grading->alone[t];
    CheckResult *check = &grading->result.checks[i];
    check->passes_alone = grading->verdicts[t].passes[i];
    check->is_own = !check->passes_alone || grading_is_finished(grading);
    if (!is_others || check->passes_alone) {
        return;
    }
    if (alone->build_log != NULL) {
        tell_lack(grading, t, check);
    } else if (alone->trouble != NULL) {
        tell_end(check, alone);
    } else if (tell_found(grading, t, i) || tell_cause(grading, t, i)) {
        return;
    } else if (check->status == CHECK_NOT_RUN) {
        check_fail(check, diagnosis_new("it fails when tested alone; what is wrong may be named "
                                        "once %s",
                                        grading->whole.build_log != NULL
                                            ? "all files compile"
                                            : "the program comes to its end"));
    } else {
        check->alone = "it also fails when tested alone";
    }
}
