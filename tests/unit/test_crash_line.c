// grader/crash_line: of the address sanitizer's report a line's number, and words of ours.
#include "crash_line.h"
#include "surroundings.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

TestSuite(crash_line, .timeout = 600);

static const Manifest manifest = {
    .lab = "02-kdtree-2d-build",
    .files = {"kdtree2d_build.c", "more.c"},
    .n_files = 2,
    .tasks = {{.id = "split_box", .file = "kdtree2d_build.c"}},
    .n_tasks = 1,
};

#define HEAD "==7==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x60\nWRITE of size 4\n"
#define IN_LIBC "    #0 0x7f in memset ../sysdeps/memset.S:12\n"
#define IN_LAB "    #1 0x55 in split_box /work/labs/02-kdtree-2d-build/kdtree2d_build.c:4\n"
#define IN_PROBE "    #2 0x55 in main tests/probes/02-kdtree-2d-build/main.c:127\n"
#define ALLOCATED                                                                                  \
    "\n0x60 is located 0 bytes after\nallocated by thread T0 here:\n    #0 0x7f in malloc\n"       \
    "    #1 0x55 in f /work/labs/02-kdtree-2d-build/more.c:9\n"

// What the report says: "file:line: words", or "".
static const char *reading(const char *report)
{
    static char said[256];
    const char *file, *says;
    const int line = crash_line_read(report, &manifest, &file, &says);
    said[0] = '\0';
    if (line > 0) {
        snprintf(said, sizeof said, "%s:%d: %s", file, line, says);
    }
    return said;
}

Test(crash_line, is_that_of_the_innermost_frame_in_a_file_of_the_lab)
{
    cr_expect_str_eq(reading(HEAD IN_LIBC IN_LAB IN_PROBE ALLOCATED),
                     "kdtree2d_build.c:4: an index or a pointer beyond the end of its array");
    cr_expect_str_eq(reading("    #0 0x55 in f labs/02-kdtree-2d-build/more.c:7\n" IN_LAB),
                     "more.c:7: it crashed here");
    cr_expect_str_eq(reading("    #0 0x55 in f labs/02-kdtree-2d-build/more.c:7:31\n"),
                     "more.c:7: it crashed here");
}

Test(crash_line, is_of_the_first_stack_only)
{
    cr_expect_str_eq(reading(HEAD IN_LIBC ALLOCATED), "");
    cr_expect_str_eq(reading(HEAD ALLOCATED), "more.c:9: an index or a pointer beyond the end of "
                                              "its array");
}

Test(crash_line, tells_faults_apart)
{
    static const char frame[] = "    #0 0x5 in f labs/02-kdtree-2d-build/more.c:7\n";
    static const char *const pairs[][2] = {
        {"stack-buffer-underflow on", "before the beginning"},
        {"global-buffer-overflow on", "beyond the end"},
        {"heap-use-after-free on", "freed before"},
        {"stack-overflow on", "the stack is full"},
        {"SEGV on unknown address 0x8\nHint: address points to the zero page.", "a null pointer"},
        {"SEGV on unknown address 0x7f", "far out of range"},
        {"FPE on unknown address", "a division by zero"},
        {"attempting double-free on", "freed twice"},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        char report[256];
        snprintf(report, sizeof report, "ERROR: AddressSanitizer: %s\n%s", pairs[i][0], frame);
        cr_expect(strstr(reading(report), pairs[i][1]), "%s: %s", pairs[i][0], reading(report));
    }
}

Test(crash_line, a_forged_report_gives_numbers_of_the_labs_files_only)
{
    static const char *const forged[] = {
        "",
        "no stack at all",
        "labs/02-kdtree-2d-build/more.c:7\n",
        "    #0 0x5 in f labs/02-kdtree-2d-build/passwd:7\n",
        "    #0 0x5 in f /etc/passwd:7\n",
        "    #0 0x5 in f labs/03-kdtree-2d-render/more.c:7\n",
        "    #0 0x5 in f labs/02-kdtree-2d-build/../more.c:7\n",
        "    #0 0x5 in f xlabs/02-kdtree-2d-build/more.c:7\n",
        "    #0 0x5 in f labs/02-kdtree-2d-build/more.c:\n",
        "    #0 0x5 in f labs/02-kdtree-2d-build/more.c:-7\n",
        "    #0 0x5 in f labs/02-kdtree-2d-build/more.c:0\n",
        "    #0 0x5 in f labs/02-kdtree-2d-build/more.c:99999999999999999999\n",
        "    #7 0x5 in f labs/02-kdtree-2d-build/more.c:7\n",
    };
    for (size_t i = 0; i < sizeof forged / sizeof *forged; i++) {
        cr_expect_str_eq(reading(forged[i]), "", "%s", forged[i]);
    }
}

// ---- In a folder --------------------------------------------------------------------------------

static void text_save(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    cr_assert_not_null(file);
    fputs(text, file);
    fclose(file);
}

static void expect_found(const char *expected, const char *expected_task)
{
    const char *task = "nobody's";
    char *found = crash_line_find("out", "lab", &manifest, &task);
    cr_expect_str_eq(found ? found : "", expected, "found %s", found ? found : "nothing");
    cr_expect_str_eq(task ? task : "", expected_task, "found task %s", task ? task : "(none)");
    free(found);
}

Test(crash_line, is_shown_from_the_file_handed_in, .init = folder_enter, .fini = folder_leave)
{
    cr_assert_eq(mkdir("out", 0700) | mkdir("lab", 0700), 0);
    text_save("lab/kdtree2d_build.c",
              "\n// TASK split_box: halve it\n    // so\n    *left = box;\n// END split_box\nlast");
    expect_found("", "");
    text_save("secret", HEAD IN_LIBC IN_LAB);
    cr_assert_eq(symlink("../secret", "out/crash.1") | mkfifo("out/crash.2", 0600), 0);
    expect_found("", "");
    text_save("out/crash.3", HEAD IN_LIBC IN_LAB IN_PROBE);
    expect_found("kdtree2d_build.c:4, task split_box: an index or a pointer beyond the end of its "
                 "array\n        *left = box;\n",
                 "split_box");
    text_save("out/crash.3", "    #0 0x5 in f labs/02-kdtree-2d-build/kdtree2d_build.c:6\n");
    expect_found("kdtree2d_build.c:6: it crashed here\n    last\n", "");
    text_save("out/crash.3", "    #0 0x5 in f labs/02-kdtree-2d-build/kdtree2d_build.c:7\n");
    expect_found("", "");
}
