// common/path: a path is whole, or nobody can open it.
#include "path.h"
#include "surroundings.h"

#include <errno.h>
#include <fcntl.h>

TestSuite(path, .init = folder_enter, .fini = folder_leave);

Test(path, is_made_of_its_parts)
{
    char path[PATH_MAX];
    path_make(path, "%s/variant-%s/%d", "/tmp", "whole", 7);
    cr_expect_str_eq(path, "/tmp/variant-whole/7");
}

// "./././name": as long as one likes, and the same file.
static void path_of_length(char path[PATH_MAX], size_t length)
{
    char folder[PATH_MAX + 16];
    for (size_t i = 0; i < length - 4; i++) {
        folder[i] = i % 2 == 0 ? '.' : '/';
    }
    folder[length - 4] = '\0';
    path_make(path, "%s%s", folder, length % 2 == 0 ? "file" : "/ile");
}

Test(path, the_longest_is_whole_and_a_longer_one_is_none)
{
    char path[PATH_MAX];
    file_write("ile", "", 0);
    path_of_length(path, PATH_MAX - 1);
    cr_expect_eq(strlen(path), PATH_MAX - 1);
    cr_expect_eq(access(path, F_OK), 0);
    // Cut off, these would be the folder itself and what is called "fil".
    file_write("fil", "", 0);
    for (size_t length = PATH_MAX; length < PATH_MAX + 5; length++) {
        path_of_length(path, length);
        cr_expect_eq(strlen(path), PATH_MAX - 1);
        cr_expect_eq(access(path, F_OK), -1);
        cr_expect_eq(errno, ENAMETOOLONG, "%zu: %s", length, strerror(errno));
    }
}
