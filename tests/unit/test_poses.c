// common/view/poses: paths in files.
#include "poses.h"
#include "surroundings.h"

TestSuite(poses, .init = folder_enter, .fini = folder_leave);

// A kind of world with three numbers.
static const WorldKind KIND = {.n_numbers = 3, .pose_line = "left, top, zoom"};

static int read_text(const char *text, Poses *poses)
{
    FILE *file = fopen("a.path", "w");
    fputs(text, file);
    fclose(file);
    return poses_read("a.path", &KIND, poses);
}

Test(poses, what_is_written_is_read)
{
    enum { N_POSES = 1000 };
    static Pose written[N_POSES];
    PosesRecord record;
    Poses found;
    cr_assert_eq(poses_record_open("a.path", &KIND, &record), 0);
    for (int i = 0; i < N_POSES; i++) {
        written[i] = (Pose){{(f32)i / 3, -1e-20f * (f32)i, 3e38f}};
        cr_assert_eq(poses_record_add(&record, &KIND, &written[i]), 0);
    }
    // Before the end: nothing is missed where there is none.
    cr_assert_eq(poses_read("a.path", &KIND, &found), 0);
    cr_assert_eq(found.n, N_POSES);
    cr_expect_arr_eq(found.poses, written, sizeof written);
    cr_expect_eq(poses_record_close(&record), 0);
    poses_free(&found);
}

Test(poses, a_full_disk_is_told_with_the_first_pose_that_is_lost)
{
    PosesRecord record = {.file = fopen("/dev/full", "w"), .path = "a.path"};
    capture_begin(STDERR_FILENO);
    const int result = poses_record_add(&record, &KIND, &(Pose){{1, 2, 3}});
    expect_one_message(capture_end(STDERR_FILENO),
                       "a.path: cannot be written: No space left on device\n");
    cr_expect_eq(result, -1);
}

Test(poses, no_more_are_read_than_fit)
{
    Poses found;
    FILE *file = fopen("a.path", "w");
    for (int i = 0; i <= POSES_MAX; i++) {
        fputs("1 2 3\n", file);
    }
    fclose(file);
    capture_begin(STDERR_FILENO);
    cr_expect_eq(poses_read("a.path", &KIND, &found), -1);
    expect_one_message(capture_end(STDERR_FILENO),
                       "a.path:1000001: found one more pose, expected at most 1000000\n");
}

Test(poses, comments_and_empty_lines_are_none)
{
    Poses found;
    cr_assert_eq(read_text("# a\n\n1 2 3\n#b\n4 5 6\n", &found), 0);
    cr_expect_eq(found.n, 2);
    cr_expect_eq(found.poses[1].numbers[2], 6);
    poses_free(&found);
}

Test(poses, faults_are_told_with_their_line)
{
    const struct Fault {
        const char *text, *message;
    } faults[] = {
        {"1 2 3\n1 2\n", "a.path:2: found 2 numbers, expected 3: left, top, zoom\n"},
        {"1 2 3 4\n", "a.path:1: found 4 numbers, expected 3: left, top, zoom\n"},
        {"1 x 3\n", "a.path:1: found \"x\", expected a number\n"},
        {"1 nan 3\n", "a.path:1: found \"nan\", expected a number\n"},
        {"# nothing\n", "a.path: found no pose, expected a line each: left, top, zoom\n"},
    };
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        Poses found;
        capture_begin(STDERR_FILENO);
        const int result = read_text(faults[i].text, &found);
        expect_one_message(capture_end(STDERR_FILENO), faults[i].message);
        cr_expect_eq(result, -1, "%s", faults[i].text);
        cr_expect_null(found.poses);
    }
}
