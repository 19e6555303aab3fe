// grader/oclgrind_log: every kind of message is told at its place, whatever else stands in the log.
#include "oclgrind_log.h"

#include <criterion/criterion.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A message as Oclgrind 21.10 writes it.
static char *message_at(const char *heading, int line, const char *file)
{
    char *text;
    cr_assert_geq(asprintf(&text,
                           "\n%s\n\tKernel: draw\n"
                           "\tEntity: Global(5,1,0) Local(5,1,0) Group(0,0,0)\n"
                           "\t  %%1 = load float\n\tAt line %d (column 12) of %s:\n"
                           "\t  source\n\t\n\n",
                           heading, line, file),
                  0);
    return text;
}

static int read_log(const char *text, Finding findings[MAX_FINDINGS], int n)
{
    char *log = strdup(text);
    n = oclgrind_log_read(log, findings, n);
    free(log);
    return n;
}

Test(oclgrind_log, each_kind_has_its_words)
{
    static const char *const kinds[][2] = {
        {"Invalid read of size 4 at global memory address 0x1000000000020", "reads outside of a "
                                                                            "buffer"},
        {"Invalid write of size 4 at global memory address 0x1", "writes outside of a buffer"},
        {"Invalid read of size 4 at private memory address 0x1", "reads outside of an array"},
        {"Invalid write of size 4 at local memory address 0x1", "writes outside of local memory"},
        {"Index (4) exceeds static array size (4)", "an array has no such index"},
        {"Uninitialized value written to global memory address 0x2", "stores a value that was "
                                                                     "never set"},
        {"Controlflow depends on uninitialized value", "decides by a value that was never set"},
        {"Read-write data race at global memory address 0x2", "a race: one work-item reads"},
        {"Write-write data race at local memory address 0x2", "a race: two work-items write"},
        {"Work-group divergence detected (barrier)", "not all work-items"},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        char *text = message_at(kinds[i][0], 17, "./leaf.cl");
        Finding findings[MAX_FINDINGS];
        cr_assert_eq(read_log(text, findings, 0), 1, "%s", kinds[i][0]);
        cr_expect(strncmp(findings[0].says, kinds[i][1], strlen(kinds[i][1])) == 0, "%s: \"%s\"",
                  kinds[i][0], findings[0].says);
        cr_expect_str_eq(findings[0].file, "leaf.cl");
        cr_expect_eq(findings[0].line, 17);
        cr_expect_str_eq(findings[0].work_item, "(5, 1)");
        cr_expect_str_eq(findings[0].other_file, "");
        free(text);
    }
}

Test(oclgrind_log, the_same_fault_is_told_once)
{
    static const struct {
        const char *heading;
        int line;
        const char *file;
        int n_then;
    } messages[] = {
        {"Invalid read of size 4 at global memory address 0x1", 3, "a.cl", 1},
        {"Invalid read of size 4 at global memory address 0x2", 3, "a.cl", 1},
        {"Invalid read of size 4 at global memory address 0x2", 4, "a.cl", 2},
        {"Invalid read of size 4 at global memory address 0x2", 3, "b.cl", 3},
        {"Invalid write of size 4 at global memory address 0x2", 3, "b.cl", 4},
        {"Invalid read of size 4 at global memory address 0x3", 4, "a.cl", 4},
    };
    Finding findings[MAX_FINDINGS];
    int n = 0;
    for (size_t i = 0; i < sizeof messages / sizeof *messages; i++) {
        char *text = message_at(messages[i].heading, messages[i].line, messages[i].file);
        n = read_log(text, findings, n);
        cr_expect_eq(n, messages[i].n_then, "message %zu: %d", i, n);
        free(text);
    }
}

Test(oclgrind_log, a_race_has_two_places)
{
    Finding findings[MAX_FINDINGS];
    const char *text = "Read-write data race at global memory address 0x2\n\tKernel: draw\n\n"
                       "\tFirst entity: Global(1,0,0) Local(1,0,0) Group(0,0,0)\n\t  load\n"
                       "\tAt line 5 (column 14) of a.cl:\n\t  x\n\n"
                       "\tSecond entity: Global(0,0,0) Local(0,0,0) Group(0,0,0)\n\t  store\n"
                       "\tAt line 9 (column 14) of a.cl:\n\t  y\n";
    cr_assert_eq(read_log(text, findings, 0), 1);
    cr_expect_eq(findings[0].line, 5);
    cr_expect_eq(findings[0].other_line, 9);
    cr_expect_str_eq(findings[0].work_item, "(1, 0)");
}

Test(oclgrind_log, what_is_no_message_is_passed_over)
{
    Finding findings[MAX_FINDINGS];
    cr_expect_eq(read_log("", findings, 0), 0);
    cr_expect_eq(read_log("\n\n\t\n", findings, 0), 0);
    cr_expect_eq(read_log("\tAt line 5 (column 14) of a.cl:\n", findings, 0), 0);
    char *other = message_at("something else", 3, "a.cl");
    cr_expect_eq(read_log(other, findings, 0), 0);
    free(other);
    // Without a place, and with one that no file has.
    cr_assert_eq(read_log("Index (4) exceeds static array size (4)\n", findings, 0), 1);
    cr_expect_str_eq(findings[0].file, "");
    cr_assert_eq(read_log("Index (4)\n\tAt line 99999999999999 (column 1) of x:\n", findings, 0),
                 1);
    char name[600];
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    char text[1024];
    snprintf(text, sizeof text, "Index (4)\n\tAt line 1 (column 1) of %s:\n", name);
    cr_assert_eq(read_log(text, findings, 0), 1);
    cr_expect_eq(strlen(findings[0].file), (size_t)FINDING_FILE_BYTES - 1);
}

Test(oclgrind_log, no_more_are_told_than_fit)
{
    char *text = calloc(100, 400);
    for (int i = 0; i < 100; i++) {
        char one[400];
        snprintf(one, sizeof one,
                 "Invalid read of size 4 at global memory address 0x1\n"
                 "\tAt line %d (column 1) of a.cl:\n",
                 i);
        strcat(text, one);
    }
    Finding findings[MAX_FINDINGS];
    cr_expect_eq(read_log(text, findings, 0), MAX_FINDINGS);
    cr_expect_eq(findings[MAX_FINDINGS - 1].line, MAX_FINDINGS - 1);
    free(text);
}
