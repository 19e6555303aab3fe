// Files of the solution's answers (see kept_answers.h).
#include "kept_answers.h"

#include "output_file.h"
#include "path.h"

#include <inttypes.h>
#include <stdint.h>

// Behind the answers stand the times, a SandboxTime for each step.
#define TIMES_SECTION "grader-times"

static void answers_path(const char *folder, uint64_t seed, char path[PATH_MAX])
{
    path_make(path, "%s/%" PRIu64, folder, seed);
}

int kept_answers_load(const char *folder, uint64_t seed, Sections *answers, Allowance *allowance)
{
    char path[PATH_MAX];
    answers_path(folder, seed, path);
    if (sections_load(path, SIZE_MAX, answers) != 0) {
        return -1;
    }
    const SandboxTime *times = sections_find(answers, TIMES_SECTION, N_STEPS * sizeof(SandboxTime));
    if (times == NULL) {
        sections_free(answers);
        return -1;
    }
    for (Step step = 0; step < N_STEPS; step++) {
        allowance_note(allowance, step, times[step]);
    }
    return 0;
}

int kept_answers_save(const char *folder, uint64_t seed, const Sections *answers,
                      const Allowance *allowance)
{
    char path[PATH_MAX];
    OutputFile output;
    answers_path(folder, seed, path);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fwrite(answers->bytes, 1, answers->n_bytes, output.file);
    section_write(output.file, TIMES_SECTION, allowance->solution, sizeof allowance->solution);
    return output_file_commit(&output);
}
