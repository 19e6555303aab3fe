// The names of numbered sections.
#include "job_sections.h"

#include "complain.h"

#include <stdlib.h>
#include <string.h>

int job_section_write(FILE *file, int k, const char *part, const void *bytes, size_t n_bytes)
{
    char name[SECTION_NAME_BYTES];
    snprintf(name, sizeof name, part ? "scene.%d.%s" : "scene.%d", k, part);
    return section_write(file, name, bytes, n_bytes);
}

int job_array_write(FILE *file, int k, const char *part, const void *array, size_t n_entries,
                    const void *beyond, size_t entry_bytes)
{
    const size_t n_bytes = n_entries * entry_bytes;
    char *longer = malloc(n_bytes + entry_bytes);
    if (longer == NULL) {
        complain("grade: no memory for a scene");
        return -1;
    }
    if (n_entries > 0) {
        memcpy(longer, array, n_bytes);
    }
    memcpy(longer + n_bytes, beyond, entry_bytes);
    const int result = job_section_write(file, k, part, longer, n_bytes + entry_bytes);
    free(longer);
    return result;
}

int job_title_write(FILE *file, int k, const char *title)
{
    return job_section_write(file, k, "title", title, strlen(title));
}

const void *job_part_find(const Sections *answers, const char *stem, int k, const char *part,
                          size_t n_bytes)
{
    char name[SECTION_NAME_BYTES];
    snprintf(name, sizeof name, part ? "%s.%d.%s" : "%s.%d", stem, k, part);
    return sections_find(answers, name, n_bytes);
}

const void *job_section_find(const Sections *answers, const char *stem, int k, size_t n_bytes)
{
    return job_part_find(answers, stem, k, NULL, n_bytes);
}
