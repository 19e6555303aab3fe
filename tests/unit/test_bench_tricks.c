// The bench of tricks: every one is found in lab 10's text, what is left out and what stays, and
// lists with hidden circles.
#include "hidden_circles.h"
#include "text_file.h"
#include "trick.h"

#include "surroundings.h"

static char top_folder[4096];

// A folder of its own to write to; the lab is read from the top folder.
static void enter(void)
{
    cr_assert_not_null(getcwd(top_folder, sizeof top_folder));
    folder_enter();
    cr_assert_eq(chdir(top_folder), 0, "start in the top folder");
}

static void leave(void)
{
    cr_assert_eq(chdir("/"), 0);
    folder_leave();
}

TestSuite(bench_tricks, .init = enter, .fini = leave);

// ---- Texts --------------------------------------------------------------------------------------

// A file of the lab without a trick.
static char *file_without(const Trick *trick, const char *file)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", surroundings_folder, trick->name);
    cr_assert_eq(trick_write(trick, path), 0, "%s", trick->name);
    snprintf(path, sizeof path, "%s/%s/%s", surroundings_folder, trick->name, file);
    return text_file_read(path);
}

Test(bench_tricks, every_trick_is_in_the_lab)
{
    for (int part = 0; part < N_PARTS; part++) {
        for (int i = 0; i < PART_TRICKS[part].n_tricks; i++) {
            const Trick *trick = &PART_TRICKS[part].tricks[i];
            for (int j = 0; j < MAX_CHANGES && trick->changes[j].file != NULL; j++) {
                char *text = file_without(trick, trick->changes[j].file);
                cr_assert_not_null(text, "%s", trick->name);
                cr_expect_not_null(strstr(text, trick->changes[j].to), "%s", trick->name);
                free(text);
            }
        }
    }
}

Test(bench_tricks, the_first_of_each_part_is_the_lab_as_it_is)
{
    char *solution = text_file_read("solutions/10-realtime/trace_tile.cl");
    for (int part = 0; part < N_PARTS; part++) {
        char *text = file_without(&PART_TRICKS[part].tricks[0], "trace_tile.cl");
        cr_expect_str_eq(text, solution);
        free(text);
    }
    free(solution);
}

Test(bench_tricks, words_that_are_not_there_once_are_a_message)
{
    const Trick nowhere = {.name = "nowhere", .changes = {{"cone.cl", "no such words", ""}}};
    const Trick twice = {.name = "twice", .changes = {{"cone.cl", "cone.axis", ""}}};
    char path[128];
    snprintf(path, sizeof path, "%s/changed", surroundings_folder);
    cr_expect_eq(WITH_MESSAGE("solutions/10-realtime/cone.cl: found \"no such words\" "
                              "nowhere, expected it once",
                              trick_write(&nowhere, path)),
                 -1);
    cr_expect_eq(
        WITH_MESSAGE("found \"cone.axis\" twice, expected it once", trick_write(&twice, path)), -1);
}

Test(bench_tricks, tiles_are_the_devices_but_for_the_trick)
{
    const TileShape usual = {2, 2, 4, 8, ""};
    const Trick none = {0}, row = {.height = 1}, large = {.width = 8, .height = 8, .lanes = 16};
    cr_expect_eq(trick_shape(&none, usual).group_side, 8);
    cr_expect_eq(trick_shape(&none, usual).lanes, 4);
    cr_expect_eq(trick_shape(&row, usual).width, 2);
    cr_expect_eq(trick_shape(&row, usual).height, 1);
    cr_expect_eq(trick_shape(&large, usual).lanes, 16);
    cr_expect_eq(trick_shape(&large, usual).group_side, 1);
}

// ---- Hidden circles -----------------------------------------------------------------------------

Test(bench_tricks, hidden_circles_are_in_every_leaf_that_they_overlap)
{
    // The first covers the picture of 32 x 32 pixels, the second only overlaps its left half, and
    // the last reaches the last column of pixels of that half, 15, and no farther.
    TileCircle circles[] = {{16, 16, 1000, 1}, {4, 4, 9, 2}, {20, 8, 25, 3}};
    TileNode one_leaf = {.split_axis = KD_LEAF, .n_circles = 3};
    const CircleTree all = {&one_leaf, circles, 1, 3};
    TileNode nodes[] = {{16, 0, 1, 0},
                        {.split_axis = KD_LEAF, .n_circles = 1},
                        {.split_axis = KD_LEAF, .n_circles = 1}};
    const CircleTree tree = {nodes, circles, 3, 1};
    CircleTree hidden;
    cr_assert_eq(hidden_circles_add(&tree, 32, &all, &hidden), 0);
    cr_assert_eq(hidden.n_nodes, 3);
    cr_expect_eq(hidden.nodes[1].n_circles, 3);
    cr_expect_eq(hidden.nodes[2].n_circles, 2);
    cr_assert_eq(hidden.n_leaf_circles, 5);
    for (u32 i = 0; i < 5; i++) {
        const u32 nearest_first[] = {1, 2, 3, 1, 3};
        cr_expect_eq(hidden.leaf_circles[i].color, nearest_first[i]);
    }
    circle_tree_free(&hidden);
}
