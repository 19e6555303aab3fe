// Files of the solution's answers (see kept_answers.h).
#include "kept_answers.h"

#include "output_file.h"

#include <inttypes.h>
#include <limits.h>
#include <stdint.h>

static void path_make(const char *folder, uint64_t seed, char path[PATH_MAX])
{
    snprintf(path, PATH_MAX, "%s/%" PRIu64, folder, seed);
}

int kept_answers_load(const char *folder, uint64_t seed, Sections *answers)
{
    char path[PATH_MAX];
    path_make(folder, seed, path);
    return sections_load(path, SIZE_MAX, answers);
}

int kept_answers_save(const char *folder, uint64_t seed, const Sections *answers)
{
    char path[PATH_MAX];
    OutputFile output;
    path_make(folder, seed, path);
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    fwrite(answers->bytes, 1, answers->n_bytes, output.file);
    return output_file_commit(&output);
}
