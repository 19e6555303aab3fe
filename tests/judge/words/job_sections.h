// The numbered sections of a job and of its answers: "scene.K.part", "picture.K".
#ifndef JUDGE_JOB_SECTIONS_H
#define JUDGE_JOB_SECTIONS_H

#include "sections.h"

#include <stdio.h>

// Write section "scene.K", or "scene.K.part" where part is not NULL. Returns 0, or -1.
int job_section_write(FILE *file, int k, const char *part, const void *bytes, size_t n_bytes);

// Write array[n_entries] as "scene.K.part", and behind its end one entry more, which must not be
// asked. Returns 0, or -1 after one message.
int job_array_write(FILE *file, int k, const char *part, const void *array, size_t n_entries,
                    const void *beyond, size_t entry_bytes);

// Write the scene's title for people as "scene.K.title": a crash is reported with it.
int job_title_write(FILE *file, int k, const char *title);

// The answer "stem.K" if it is there with exactly n_bytes; else NULL.
const void *job_section_find(const Sections *answers, const char *stem, int k, size_t n_bytes);

// The same for "stem.K.part".
const void *job_part_find(const Sections *answers, const char *stem, int k, const char *part,
                          size_t n_bytes);

#endif
