// grader/descriptors: what was inherited is closed, on kernels without close_range(), too.
#include "descriptors.h"

#include "surroundings.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <seccomp.h>
#include <sys/prctl.h>

TestSuite(descriptors, .init = folder_enter, .fini = folder_leave);

static int is_open(int descriptor)
{
    return fcntl(descriptor, F_GETFD) >= 0;
}

static void expect_closed(void)
{
    // Many, as a list of them is read in blocks.
    enum { FIRST = 100, LAST = 899 };
    for (int i = FIRST; i <= LAST; i++) {
        cr_assert_eq(dup2(STDERR_FILENO, i), i);
    }
    cr_expect_eq(descriptors_close(FIRST + 1, LAST - 1), 0);
    for (int i = FIRST + 1; i < LAST; i++) {
        cr_expect_not(is_open(i), "%d is open", i);
    }
    cr_expect(is_open(FIRST) && is_open(LAST), "too much was closed");
    cr_expect_eq(descriptors_close(LAST, INT_MAX), 0);
    cr_expect_not(is_open(LAST));
    cr_expect_eq(descriptors_close(LAST, LAST - 1), 0, "none to close");
}

Test(descriptors, a_range_is_closed)
{
    expect_closed();
}

Test(descriptors, a_range_is_closed_where_the_kernel_has_no_call_for_it)
{
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    cr_assert_eq(seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(close_range), 0), 0);
    cr_assert_eq(seccomp_load(filter), 0);
    seccomp_release(filter);
    cr_assert_eq(close_range(100, 200, 0), -1, "the test's kernel has the call");
    expect_closed();
}
