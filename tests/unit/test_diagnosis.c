// grader/verdict/diagnosis: the sentence of a diagnosis, and the names of kinds.
#include "diagnosis.h"
#include "message.h"
#include "told.h"

#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

TestSuite(diagnosis);

static void expect_told(Diagnosis diagnosis, const char *expected)
{
    char *message = told(diagnosis);
    cr_expect(expected != NULL && message != NULL ? strcmp(message, expected) == 0
                                                  : message == expected,
              "found \"%s\", expected \"%s\"", message ? message : "(nothing)",
              expected ? expected : "(nothing)");
    free(message);
}

static const Cause cause = {"the shorter side was split", MISTAKE_TRANSPOSED};

Test(diagnosis, is_told_as_facts_and_cause)
{
    expect_told(diagnosis_new("found %d, expected %d", 1, 0), "found 1, expected 0");
    expect_told(diagnosis_of(message_new("found 1"), cause), "found 1; the shorter side was split");
    expect_told(diagnosis_of(message_new("found 1"), (Cause){.mistake = MISTAKE_GAMMA}), "found 1");
    expect_told(diagnosis_seen(message_new("found 1"), (Cause){.says = "grey"}, EVIDENCE_RAYS),
                "found 1; it looks grey");
    expect_told(diagnosis_at("a scene", diagnosis_of(message_new("found 1"), cause)),
                "a scene: found 1; the shorter side was split");
}

Test(diagnosis, nothing_wrong_is_told_as_nothing)
{
    const Diagnosis right = NOTHING_WRONG;
    char *message = diagnosis_text(&right);
    cr_expect_str_eq(message, "");
    free(message);
    expect_told(diagnosis_at("a scene", NOTHING_WRONG), NULL);
}

// A student's text may look like ours: only the field is the cause.
Test(diagnosis, a_semicolon_among_the_facts_is_no_cause)
{
    Diagnosis diagnosis = diagnosis_new("found \"%s\"", "1; it looks right");
    cr_expect_null(diagnosis.cause);
    cr_expect_eq(diagnosis.mistake, MISTAKE_NONE);
    diagnosis_free(&diagnosis);
    cr_expect_null(diagnosis.found);
}

Test(diagnosis, keeps_the_kinds)
{
    Diagnosis of = diagnosis_at("a scene", diagnosis_of(message_new("found 1"), cause));
    Diagnosis seen = diagnosis_seen(message_new("found 1"), cause, EVIDENCE_PICTURE);
    cr_expect_eq(of.mistake, MISTAKE_TRANSPOSED);
    cr_expect_eq(of.evidence, EVIDENCE_VALUES);
    cr_expect_eq(seen.mistake, MISTAKE_TRANSPOSED);
    cr_expect_eq(seen.evidence, EVIDENCE_PICTURE);
    diagnosis_free(&of);
    diagnosis_free(&seen);
}

Test(diagnosis, each_kind_is_found_by_its_name)
{
    for (Mistake mistake = MISTAKE_NONE; mistake < N_MISTAKES; mistake++) {
        cr_assert_not_null(mistake_name(mistake), "kind %d has no name", (int)mistake);
        cr_expect_eq(mistake_find(mistake_name(mistake)), mistake);
    }
    cr_expect_eq(mistake_find("flipped-z"), MISTAKE_NONE);
}
