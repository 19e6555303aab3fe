// JUnit XML (see report_systems.h): a test case a stage and a check.
//
// The format has no standard; this keeps to what the readers of Jenkins, GitLab and GitHub share
// (tests/systems/junit.xsd). What did not run is skipped, and the stage that kept it
// from running has failed, so that no reader takes the whole for good.
// Flow: judging -> result -> REPORTS. Read next: report_tap.c.
#include "html.h"
#include "output_file.h"
#include "report_systems.h"
#include "report_words.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

typedef struct Counts {
    int tests, failures, skipped;
} Counts;

static void count(Counts *counts, CheckStatus status)
{
    counts->tests++;
    counts->failures += status == CHECK_FAILED;
    counts->skipped += status == CHECK_NOT_RUN;
}

static void case_write(FILE *file, const char *group, const char *name, CheckStatus status,
                       const char *message, const char *words)
{
    fputs("    <testcase classname=\"", file);
    html_line(file, group);
    fputs("\" name=\"", file);
    html_line(file, name);
    if (status == CHECK_PASSED) {
        // A remark on what went well: the stage that tells what stands out has one.
        const int remark = words != NULL && words[0] != '\0';
        fputs(remark ? "\">\n      <system-out>" : "\"/>\n", file);
        html_text(file, words);
        fputs(remark ? "</system-out>\n    </testcase>\n" : "", file);
        return;
    }
    const char *element = status == CHECK_FAILED ? "failure" : "skipped";
    fprintf(file, "\">\n      <%s message=\"", element);
    html_line(file, message);
    fputs("\">", file);
    html_text(file, words);
    fprintf(file, "</%s>\n    </testcase>\n", element);
}

static void property_write(FILE *file, const char *name, const char *value)
{
    fprintf(file, "      <property name=\"%s\" value=\"", name);
    html_line(file, value);
    fputs("\"/>\n", file);
}

static void properties_write(FILE *file, const Result *result)
{
    char *points = points_words(result->score, result->max_score);
    char seed[24];
    snprintf(seed, sizeof seed, "%" PRIu64, result->seed);
    fputs("    <properties>\n", file);
    property_write(file, "score", points);
    property_write(file, "seed", seed);
    property_write(file, "device", result->device);
    property_write(file, "submission", result->submission);
    fputs("    </properties>\n", file);
    free(points);
}

static void cases_write(FILE *file, const Manifest *manifest, const Result *result)
{
    for (int i = 0; i < result->n_stages; i++) {
        const StageResult *stage = &result->stages[i];
        case_write(file, result->lab, stage->title, stage->status, stage->message, stage->message);
    }
    for (int i = 0; i < result->n_checks; i++) {
        const CheckResult *check = &result->checks[i];
        char *words = check_words(manifest, result, check);
        case_write(file, check->task, check->title, check->status, check->message, words);
        free(words);
    }
}

// Everything up to the first test case.
static void head_write(FILE *file, const char *lab, Counts counts, int errors, double seconds)
{
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n", file);
    static const char *const elements[] = {"<testsuites", "  <testsuite"};
    for (int i = 0; i < 2; i++) {
        fprintf(file, "%s name=\"", elements[i]);
        html_line(file, lab);
        fprintf(file, "\" tests=\"%d\" failures=\"%d\" errors=\"%d\"", counts.tests,
                counts.failures, errors);
        // On the outer element Jenkins' xUnit plugin knows no such attribute, and refuses the file.
        if (i == 1) {
            fprintf(file, " skipped=\"%d\"", counts.skipped);
        }
        fprintf(file, " time=\"%.3f\">\n", seconds);
    }
}

static int tail_write(OutputFile *output)
{
    fputs("  </testsuite>\n</testsuites>\n", output->file);
    return output_file_commit(output);
}

int report_junit(const char *path, const Manifest *manifest, const Result *result)
{
    if (!isfinite(result->seconds)) {
        fprintf(stderr, "%s: cannot write: a figure is not finite\n", path);
        return -1;
    }
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    Counts counts = {0};
    for (int i = 0; i < result->n_stages; i++) {
        count(&counts, result->stages[i].status);
    }
    for (int i = 0; i < result->n_checks; i++) {
        count(&counts, result->checks[i].status);
    }
    head_write(output.file, result->lab, counts, 0, result->seconds);
    properties_write(output.file, result);
    cases_write(output.file, manifest, result);
    return tail_write(&output);
}

int report_junit_fault(const char *path, const char *lab)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    head_write(output.file, lab, (Counts){.tests = 1}, 1, 0);
    fputs("    <testcase classname=\"", output.file);
    html_line(output.file, lab);
    fputs("\" name=\"grader\">\n      <error message=\"" FORMATS_FAULT_TEXT
          "\"/>\n    </testcase>\n",
          output.file);
    return tail_write(&output);
}
