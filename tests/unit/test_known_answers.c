// mutation/groups and mutation/tried_alone: which known answers stand in the solution together,
// and which are tried alone.
#include "groups.h"

#include <criterion/criterion.h>

TestSuite(known_answers);

static const Task tasks[] = {
    {.id = "clip_to_box"}, {.id = "search_leaf"}, {.id = "next_waiting"}, {.id = "near_side"}};
enum { CLIP, LEAF, WAITING, SIDE };

static const Settings settings = {.seed = 1};
static Session session = {
    .settings = &settings,
    .judge = {.n_checks = 5,
              .checks = {{.id = "clip-inside", .task = "clip_to_box"},
                         {.id = "leaf-ids", .task = "search_leaf", .needs = ""},
                         {.id = "waiting-steps", .task = "next_waiting"},
                         {.id = "side-zero", .task = "near_side", .needs = "clip_to_box"},
                         {.id = "waiting-picture", .task = "next_waiting", .needs = "*"}}},
};

enum { MAX_ANSWERS = 8 };
static KnownAnswer answers[MAX_ANSWERS];
static KnownAnswer *all[MAX_ANSWERS];
static Group groups[MAX_ANSWERS];
static int n_answers;

static void add(int task, const char *check)
{
    KnownAnswer *answer = &answers[n_answers];
    *answer = (KnownAnswer){.task = &tasks[task], .is_right = check == NULL, .check = check};
    all[n_answers++] = answer;
}

// Are exactly these two in a group?
static void expect_pair(const Group *group, int first, int second)
{
    cr_expect_eq(group->n, 2);
    cr_expect_eq(group->answers[0], &answers[first]);
    cr_expect_eq(group->answers[1], &answers[second]);
}

static void expect_alone(const Group *group, int only)
{
    cr_expect_eq(group->n, 1);
    cr_expect_eq(group->answers[0], &answers[only]);
}

// ---- Groups -------------------------------------------------------------------------------------

Test(known_answers, right_ones_to_different_tasks_stand_together)
{
    add(CLIP, NULL);
    add(CLIP, NULL);
    add(LEAF, NULL);
    add(WAITING, NULL);
    add(WAITING, NULL);
    cr_assert_eq(groups_form(&session, all, n_answers, 0, groups), 2);
    cr_expect_eq(groups[0].n, 3);
    cr_expect_eq(groups[0].answers[2], &answers[3]);
    expect_pair(&groups[1], 1, 4);
}

Test(known_answers, wrong_ones_of_which_neighbours_change_nothing_stand_together)
{
    add(CLIP, "clip-inside");
    add(CLIP, "clip-inside");
    add(LEAF, "leaf-ids");
    add(LEAF, "leaf-ids");
    add(LEAF, "leaf-ids");
    cr_assert_eq(groups_form(&session, all, n_answers, 0, groups), 3);
    expect_pair(&groups[0], 0, 2);
    expect_pair(&groups[1], 1, 3);
    expect_alone(&groups[2], 4);
}

// A neighbour's mistake would show in the picture, and the picture might be said to show it.
Test(known_answers, no_wrong_one_stands_beside_a_task_that_its_checks_need)
{
    add(WAITING, "waiting-steps");
    add(CLIP, "clip-inside");
    add(LEAF, "leaf-ids");
    add(SIDE, "side-zero");
    add(CLIP, "clip-inside");
    cr_assert_eq(groups_form(&session, all, n_answers, 0, groups), 4);
    expect_alone(&groups[0], 0);
    expect_pair(&groups[1], 1, 2);
    expect_alone(&groups[2], 3);
    expect_alone(&groups[3], 4);
}

Test(known_answers, right_and_wrong_ones_never_stand_together)
{
    add(CLIP, "clip-inside");
    add(LEAF, NULL);
    cr_assert_eq(groups_form(&session, all, n_answers, 0, groups), 2);
    expect_alone(&groups[0], 0);
    expect_alone(&groups[1], 1);
}

Test(known_answers, each_stands_by_itself_where_that_is_asked_for)
{
    add(CLIP, NULL);
    add(LEAF, NULL);
    add(CLIP, "clip-inside");
    add(LEAF, "leaf-ids");
    cr_assert_eq(groups_form(&session, all, n_answers, 1, groups), 4);
    for (int g = 0; g < 4; g++) {
        expect_alone(&groups[g], g);
    }
}

// ---- Alone --------------------------------------------------------------------------------------

Test(known_answers, the_seed_says_which_one_of_a_check_is_tried_alone)
{
    add(WAITING, "waiting-picture");
    add(WAITING, "waiting-picture");
    add(WAITING, "waiting-picture");
    answers[0].passes_alone = 1;
    answers_choose_alone(&session, all, n_answers, 0);
    cr_expect_eq(answers[0].is_tried_alone, 0, "it would pass");
    cr_expect_eq(answers[1].is_tried_alone, 0);
    cr_expect_eq(answers[2].is_tried_alone, 1, "seed 1: the second of two");
    answers_choose_alone(&session, all, n_answers, 1);
    cr_expect_eq(answers[0].is_tried_alone, 0);
    cr_expect_eq(answers[1].is_tried_alone, 1);
}

Test(known_answers, alone_nothing_is_learnt_of_a_check_that_needs_no_others)
{
    add(LEAF, "leaf-ids");
    answers_choose_alone(&session, all, n_answers, 1);
    cr_expect_eq(answers[0].is_tried_alone, 0);
}
