// memcheck/sanitizer_log: each kind of report is told in its words at the student's own line,
// whatever else stands in it.
#include "sanitizer_log.h"

#include <criterion/criterion.h>
#include <stdio.h>
#include <string.h>

static const Manifest manifest = {
    .lab = "03-kdtree-2d-render", .files = {"host.c", "KD.cl"}, .n_files = 2};

// Where most reports here are: a given function, and the student's line that calls it.
#define FRAMES                                                                                     \
    "    #0 0x7f8e21 in todo_pop /work/solutions/02-kdtree/todo.h:30\n"                            \
    "    #1 0x7f8e22 in leaf_loop /work/labs/03-kdtree-2d-render/KD.cl:41:9\n"                     \
    "    #2 0x7f8e23 in run_item /course/tests/native/launch.c:203\n\n"

static Finding read_report(const char *report, const char *place)
{
    Finding finding;
    cr_assert_eq(finding_read(report, place, &manifest, &finding), 1, "%s", report);
    return finding;
}

// What is said of a report with the frames between its two parts.
static void expect(const char *before, const char *behind, const char *place, const char *says)
{
    char report[2048];
    snprintf(report, sizeof report, "%s\n" FRAMES "%s\n", before, behind);
    const Finding finding = read_report(report, place);
    cr_expect_str_eq(finding.says, says);
    cr_expect_str_eq(finding.file, "KD.cl");
    cr_expect_eq(finding.line, 41);
    cr_expect_str_eq(finding.given, "solutions/02-kdtree/todo.h");
    cr_expect_eq(finding.given_line, 30);
}

Test(sanitizer_log, an_array_is_told_with_its_entries)
{
    const char *read = "==7==ERROR: AddressSanitizer: SEGV on unknown address 0x7\n"
                       "==7==The signal is caused by a READ memory access.";
    const char *write = "==7==ERROR: AddressSanitizer: use-after-poison\nWRITE of size 4 at 0x7";
    expect(read, "", "item 3 0\narray circles 4 4\n",
           "reads circles[4], but `circles` has 4 entries, 0 to 3");
    expect(read, "", "array circles -1 4\n",
           "reads circles[-1], but `circles` has 4 entries, 0 to 3");
    expect(read, "", "array circles 4294967295 4\n",
           "reads circles[4294967295 (-1 as a uint)], but `circles` has 4 entries, 0 to 3");
    expect(
        read, "", "array circles -9223372036854775808 9223372036854775807\n",
        "reads circles[-9223372036854775808], but `circles` has 9223372036854775807 entries, 0 to "
        "9223372036854775806");
    expect(write, "", "array d_work 1 1\n",
           "writes d_work[1], but `d_work` has one entry, d_work[0]");
}

Test(sanitizer_log, a_variable_is_told_with_its_name)
{
    const char *read = "==7==ERROR: AddressSanitizer: stack-buffer-overflow\nREAD of size 4 at 0x7";
    const char *write = "==7==ERROR: AddressSanitizer: stack-buffer-underflow\nWRITE of size 4";
    expect(read,
           "    [32, 48) 'ids' (line 9) <== Memory access at offset 48 overflows this variable", "",
           "reads beyond the end of `ids`");
    expect(write, "    [32, 48) 'ids' <== Memory access at offset 28 underflows this variable", "",
           "writes before the beginning of `ids`");
}

Test(sanitizer_log, what_is_undefined_has_its_words)
{
    static const char place[] = "labs/03-kdtree-2d-render/KD.cl:41:9: runtime error: ";
    char report[512];
    snprintf(report, sizeof report, "%sindex 4 out of bounds for type 'uint[4]' (aka 'x')", place);
    expect(report, "", "", "uses index 4 of an array of 4 entries, 0 to 3");
    snprintf(report, sizeof report, "%sdivision by zero", place);
    expect(report, "", "", "divides by zero");
    snprintf(report, sizeof report, "%ssigned integer overflow: 2147483647 + 1 cannot be", place);
    expect(report, "", "", "computes a number that is too large for its type");
    // Whoever wrote it: the words are ours, and only of its own line.
    snprintf(report, sizeof report, "%syou have every point\nshift", place);
    expect(report, "", "", "does what C leaves undefined");
}

Test(sanitizer_log, a_value_that_was_never_set_has_a_name_where_it_is_known)
{
    const char *unset = "==7==WARNING: MemorySanitizer: use-of-uninitialized-value";
    expect(unset, "", "", "uses a value that was never set");
    // clang 14 and clang 19.
    expect(unset,
           "  Uninitialized value was created by an allocation of 'depth' in the stack frame of "
           "function 'leaf_loop'\n    #0 0x7f8e24 in leaf_loop KD.cl:3",
           "", "uses a value that was never set, of `depth`");
    expect(unset,
           "  Uninitialized value was created by an allocation of 'depth' in the stack frame\n"
           "    #0 0x7f8e24 in leaf_loop KD.cl:3",
           "", "uses a value that was never set, of `depth`");
}

Test(sanitizer_log, a_fault_of_the_hosts_is_told_as_after_a_crash)
{
    const Finding finding =
        read_report("==7==ERROR: AddressSanitizer: heap-use-after-free on address 0x6\n"
                    "READ of size 4 at 0x6\n"
                    "    #0 0x55 in read_back /work/labs/03-kdtree-2d-render/host.c:12:5\n",
                    "");
    cr_expect_str_eq(finding.says, "memory is used that was freed before");
    cr_expect_str_eq(finding.file, "host.c");
    cr_expect_eq(finding.line, 12);
    cr_expect_str_eq(finding.given, "");
    cr_expect_null(finding.to_do);
}

Test(sanitizer_log, a_given_file_is_told_where_no_line_is_the_students)
{
    const Finding finding =
        read_report("==7==ERROR: AddressSanitizer: SEGV on unknown address 0x7\n"
                    "    #0 0x7f8e21 in todo_pop /work/kernels/todo.h:30\n",
                    "item 3 5\n");
    cr_expect_null(finding.file);
    cr_expect_str_eq(finding.given, "kernels/todo.h");
    cr_expect_str_eq(finding.work_item, "(3, 5)");
}

Test(sanitizer_log, what_tells_of_no_known_line_is_no_finding)
{
    static const char *const reports[] = {
        "",
        "\n\n    #0 ",
        "==7==ERROR: AddressSanitizer: SEGV on unknown address 0x7\n",
        "    #0 0x7f8e21 in main /course/tests/probes/probe.c:30\n",
        "    #0 0x7f8e21 in f /work/labs/01-naive-2d/KD.cl\n",
        "    #0 0x7f8e21 in f /work/kernels/../../secret.h:3\n",
        "    #0 0x7f8e21 in f /work/kernels/todo.h:0\n",
        "    #0 0x7f8e21 in f /work/labs/03-kdtree-2d-render/KD.cl:99999999999999999999\n",
        "    #1 0x7f8e21 in f /work/labs/03-kdtree-2d-render/KD.cl:3\n",
    };
    Finding finding;
    for (size_t i = 0; i < sizeof reports / sizeof *reports; i++) {
        cr_expect_eq(finding_read(reports[i], "", &manifest, &finding), 0, "report %zu", i);
    }
}

// Both files are a student's to write: whatever is in them, what is told stays within its bounds.
Test(sanitizer_log, whatever_stands_in_a_place_is_no_harm)
{
    static const char *const places[] = {
        "item",
        "item -1 x",
        "array",
        "array circles",
        "array circles 4",
        "array ! 4 4",
        "array a\x1b[31m 4 4",
        "array circles 99999999999999999999 4",
        "array circles 4 0",
        "array circles 4 -9223372036854775808",
    };
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        const Finding finding = read_report("ERROR: points to the zero page\n" FRAMES, places[i]);
        cr_expect_null(strchr(finding.says, '\x1b'), "place %zu", i);
        cr_expect_str_eq(finding.work_item, "", "place %zu", i);
    }
    char name[4096];
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    char report[8192];
    snprintf(report, sizeof report,
             "created by an allocation of '%s' use-of-uninitialized-value\n" FRAMES, name);
    cr_expect_lt(strlen(read_report(report, "").says), sizeof((Finding *)NULL)->says);
}
