// What the linker says, in the lab's own paths.
#include "linker_lines.h"

#include <criterion/criterion.h>
#include <stdio.h>

#define FAILED "\ncollect2: error: ld returned 1 exit status\n"

static void expect_lines(const char *output, const char *expected)
{
    char text[512];
    snprintf(text, sizeof text, "%s", output);
    linker_lines_shorten(text);
    cr_expect_str_eq(text, expected);
}

Test(linker_lines, a_file_of_the_course_stands_below_its_top_folder)
{
    expect_lines("/work/labs/02-a/a.c:3: undefined reference to `f'" FAILED,
                 "labs/02-a/a.c:3: undefined reference to `f'" FAILED);
    expect_lines("/home/labs/course/tests/probes/02-a/main.c:32: undefined" FAILED,
                 "tests/probes/02-a/main.c:32: undefined" FAILED);
    expect_lines("/usr/bin/ld: lib/libcommon.a(image.c.o):/x/common/image.c:9: multiple" FAILED,
                 "/usr/bin/ld: lib/libcommon.a(image.c.o):common/image.c:9: multiple" FAILED);
}

Test(linker_lines, an_object_of_no_lasting_name_is_the_students_code)
{
    expect_lines("/usr/bin/ld: /tmp/ccIUeTsh.o: in function `f':" FAILED,
                 "/usr/bin/ld: your code: in function `f':" FAILED);
    expect_lines("/usr/bin/ld: /tmp/ccIUeTsh.o:(.bss+0x0): multiple definition of `x'; "
                 "/tmp/ccAAAAAA.o:(.bss+0x0): first defined here" FAILED,
                 "/usr/bin/ld: your code:(.bss+0x0): multiple definition of `x'; "
                 "your code:(.bss+0x0): first defined here" FAILED);
}

// Of a file that compiles and is linked.
Test(linker_lines, so_is_it_in_warnings)
{
    expect_lines(
        "/usr/bin/ld: /tmp/ccIUeTsh.o: in function `f':\n/work/labs/02-a/a.c:3: warning: no\n",
        "/usr/bin/ld: your code: in function `f':\nlabs/02-a/a.c:3: warning: no\n");
    expect_lines("/tmp/ccIUeTsh.s: Assembler messages:\n", "your code: Assembler messages:\n");
}

Test(linker_lines, what_else_is_said_stays_as_it_is)
{
    expect_lines("", "");
    expect_lines("a.c:1: error: /x/common/y is no path\n",
                 "a.c:1: error: /x/common/y is no path\n");
    expect_lines("/usr/bin/ld: cannot find -lfoo" FAILED, "/usr/bin/ld: cannot find -lfoo" FAILED);
    expect_lines("/tmp/ccIUeTsh.object, 1/2, /labs/" FAILED,
                 "/tmp/ccIUeTsh.object, 1/2, /labs/" FAILED);
}
