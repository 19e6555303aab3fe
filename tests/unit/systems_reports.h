// A result in the forms of other systems, each test's in a folder of its own.
//
// The forms are made as everywhere, of the results.json that the grader writes. Read next:
// test_report_systems.c.
#ifndef UNIT_SYSTEMS_REPORTS_H
#define UNIT_SYSTEMS_REPORTS_H

#include "report.h"
#include "sample_result.h"

#include <criterion/criterion.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define ALL "junit,tap,gradescope,autolab,prairielearn,github,vpl"

// A folder of its own for each test; Criterion runs each in a process of its own.
static char folder[] = "/tmp/test-systems-XXXXXX";

static inline void folder_make(void)
{
    cr_assert_not_null(mkdtemp(folder));
}

static inline void folder_remove(void)
{
    static const char *const files[] = {
        "results.json", "pictures.json", "junit.xml", "results.tap",       "gradescope.json",
        "autolab.txt",  "github.txt",    "said",      "prairielearn.json", "vpl.txt"};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        char path[64];
        snprintf(path, sizeof path, "%s/%s", folder, files[i]);
        unlink(path);
    }
    cr_expect_eq(rmdir(folder), 0, "something else was left in the folder");
}

// Write the formats of what lies in the folder, after a command that stands for the grader; "" for
// none. Returns the script's exit status; what it said is in the file "said".
static inline int formats_write(const char *formats, const char *command)
{
    char line[512];
    snprintf(line, sizeof line, "tests/systems/formats/write.sh '%s' %s 01-naive-2d %s 2>%s/said",
             formats, folder, command, folder);
    const int status = system(line);
    cr_assert(WIFEXITED(status));
    return WEXITSTATUS(status);
}

// What the grader writes of a result. Returns 0 or -1.
static inline int result_write(const Result *result)
{
    char path[64];
    snprintf(path, sizeof path, "%s/results.json", folder);
    if (report_json(path, &manifest, result) != 0) {
        return -1;
    }
    snprintf(path, sizeof path, "%s/pictures.json", folder);
    return report_pictures_json(path, result);
}

static inline void write_all(const Result *result)
{
    cr_assert_eq(result_write(result), 0);
    cr_assert_eq(formats_write(ALL, ""), 0);
}

// A file's text; free() it. NULL when it is not there.
static char *text_of(const char *name)
{
    char path[64];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    struct stat status;
    if (file == NULL || fstat(fileno(file), &status) != 0) {
        return NULL;
    }
    char *text = calloc(1, (size_t)status.st_size + 1);
    cr_assert_eq(fread(text, 1, (size_t)status.st_size, file), (size_t)status.st_size);
    fclose(file);
    cr_expect_eq(strlen(text), (size_t)status.st_size, "%s holds a NUL", name);
    return text;
}

static inline int is_written(const char *name)
{
    char path[64];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return access(path, F_OK) == 0;
}

static inline json_t *json_of(const char *name)
{
    char *text = text_of(name);
    cr_assert_not_null(text, "%s was not written", name);
    json_error_t error;
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES, &error);
    cr_assert_not_null(json, "%s: line %d: %s", name, error.line, error.text);
    free(text);
    return json;
}

static const char *string_at(const json_t *list, size_t i, const char *name)
{
    const char *string = json_string_value(json_object_get(json_array_get(list, i), name));
    return string != NULL ? string : "";
}

static inline void expect_part(const char *text, const char *part)
{
    cr_expect(strstr(text, part) != NULL, "expected \"%s\" in:\n%s", part, text);
}

static inline int count_parts(const char *text, const char *part)
{
    int n = 0;
    while ((text = strstr(text, part)) != NULL) {
        text += strlen(part);
        n++;
    }
    return n;
}

#endif
