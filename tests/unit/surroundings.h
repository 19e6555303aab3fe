// What a unit test needs around it: a folder of its own, and the messages that a call prints.
//
// Criterion runs every test in a process of its own, so a changed folder or stderr disturbs no
// other. Read next: test_output_file.c, the shortest suite.
#ifndef UNIT_SURROUNDINGS_H
#define UNIT_SURROUNDINGS_H

#include <criterion/criterion.h>
#include <dirent.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// ---- A folder of its own ------------------------------------------------------------------------

static char surroundings_folder[64];

// For .init: go to a new, empty folder.
static inline void folder_enter(void)
{
    strcpy(surroundings_folder, "/tmp/unit-XXXXXX");
    cr_assert_not_null(mkdtemp(surroundings_folder));
    cr_assert_eq(chdir(surroundings_folder), 0);
}

static inline int entry_remove(const char *path, const struct stat *status, int kind,
                               struct FTW *position)
{
    (void)status, (void)kind, (void)position;
    return remove(path);
}

// For .fini: remove it with all that is in it, the innermost first.
static inline void folder_leave(void)
{
    nftw(surroundings_folder, entry_remove, 16, FTW_DEPTH | FTW_PHYS);
}

// Where several tests are skipped, Criterion itself loses what it noted about all but the last.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libcriterion";
}

// Skip a test. Criterion then leaves out .fini, so the folder goes here.
#define SKIP_TEST(reason)                                                                          \
    do {                                                                                           \
        folder_leave();                                                                            \
        cr_skip_test(reason);                                                                      \
    } while (0)

// How many files the current folder holds.
static inline int folder_count(void)
{
    int n_entries = 0;
    DIR *folder = opendir(".");
    while (readdir(folder) != NULL) {
        n_entries++;
    }
    closedir(folder);
    return n_entries - 2;  // "." and ".."
}

static inline void file_write(const char *path, const char *text, size_t length)
{
    FILE *file = fopen(path, "wb");
    cr_assert_not_null(file);
    cr_assert_eq(fwrite(text, 1, length, file), length);
    fclose(file);
}

// The first line of a file.
static inline void expect_content(const char *path, const char *expected)
{
    char text[64] = "";
    FILE *file = fopen(path, "r");
    cr_assert_not_null(file, "%s", path);
    cr_expect(fgets(text, sizeof text, file) != NULL);
    cr_expect_str_eq(text, expected);
    fclose(file);
}

// ---- What a call prints -------------------------------------------------------------------------

static char captured_text[64 * 1024];
static int captured_real_descriptor;
static FILE *captured_file;

// Send standard error (2) or output (1) to a file from here on.
static inline void capture_begin(int descriptor)
{
    fflush(NULL);
    captured_file = tmpfile();
    captured_real_descriptor = dup(descriptor);
    dup2(fileno(captured_file), descriptor);
}

// Send it back. Returns what was printed.
static inline const char *capture_end(int descriptor)
{
    fflush(NULL);
    dup2(captured_real_descriptor, descriptor);
    close(captured_real_descriptor);
    rewind(captured_file);
    size_t length = fread(captured_text, 1, sizeof captured_text - 1, captured_file);
    captured_text[length] = '\0';
    fclose(captured_file);
    return captured_text;
}

// One fault gives one message: a line, not more, that holds `part`.
static inline void expect_one_message(const char *message, const char *part)
{
    const char *end = strchr(message, '\n');
    cr_expect(end != NULL && end[1] == '\0', "not exactly one line: \"%s\"", message);
    cr_expect_not_null(strstr(message, part), "no \"%s\" in \"%s\"", part, message);
}

static inline int message_follows(const char *part, int result)
{
    expect_one_message(capture_end(2), part);
    return result;
}

// What a call returns that prints one such message on standard error.
#define WITH_MESSAGE(part, call) (capture_begin(2), message_follows(part, call))

#endif
