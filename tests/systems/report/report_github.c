// The points for GitHub Classroom (see report_systems.h), as its own reporter prints them: two
// workflow commands, which become annotations of the run.
//
// Only numbers stand in them. The workflow must print nothing of a student's beside them, as any
// line that begins with "::" is a command; tests/systems/github/ keeps to that.
// Flow: judging -> result -> REPORTS. Read next: report_systems.c.
#include "output_file.h"
#include "report_systems.h"

int report_github(const char *path, const Manifest *manifest, const Result *result)
{
    (void)manifest;
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fprintf(output.file,
            "::notice title=Autograding complete::Points %d/%d\n"
            "::notice title=Autograding report::{\"totalPoints\":%d,\"maxPoints\":%d}\n",
            result->score, result->max_score, result->score, result->max_score);
    return output_file_commit(&output);
}
