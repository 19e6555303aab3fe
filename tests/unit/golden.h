// Texts that are kept whole, in tests/unit/golden/: a test compares what it makes with all of such
// a file.
//
// After a change that is meant, `GOLDEN=write tests/run.sh test_report_systems` writes the test's
// files anew; `git diff` shows what has changed.
#ifndef UNIT_GOLDEN_H
#define UNIT_GOLDEN_H

#include <criterion/criterion.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Is the text that of the file with this name? If not, the message is their difference.
static inline void expect_golden(const char *name, const char *text)
{
    const char *mode = getenv("GOLDEN");
    char kept[128], found[] = "/tmp/golden-XXXXXX", command[256], difference[16384] = "";
    snprintf(kept, sizeof kept, "tests/unit/golden/%s", name);
    const int is_written = mode != NULL && strcmp(mode, "write") == 0;
    FILE *file = is_written ? fopen(kept, "w") : fdopen(mkstemp(found), "w");
    cr_assert_not_null(file, "%s: start in the top folder", kept);
    fputs(text, file);
    fclose(file);
    if (!is_written) {
        snprintf(command, sizeof command, "diff -u %s %s 2>&1", kept, found);
        FILE *diff = popen(command, "r");
        cr_assert_not_null(diff);
        difference[fread(difference, 1, sizeof difference - 1, diff)] = '\0';
        cr_expect_eq(pclose(diff), 0, "%s", difference);
        remove(found);
    }
}

#endif
