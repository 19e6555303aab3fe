// class/grading/class_keys and class_secret: which hidden scenes each entry of a class gets.
//
// What the driver does with them is in suites/seeds.sh.
#include "class_keys.h"

#include "class_secret.h"
#include "surroundings.h"

#include <inttypes.h>
#include <string.h>

TestSuite(class_keys, .init = folder_enter, .fini = folder_leave);

enum { MANY = 200 };

typedef struct Keys {
    uint64_t seeds[MANY];
    int n;
} Keys;

static const uint64_t five = 5;

// The entries number `first` to first + n - 1, whose contents are of this version.
static Keys keys_of(int first, int n, char version, const char *grader)
{
    Keys keys = {0};
    FILE *contents = tmpfile();
    cr_assert_not_null(contents);
    for (int i = first; i < first + n; i++) {
        fprintf(contents, "student-%d %063d%c\n", i, i, version);
    }
    rewind(contents);
    cr_assert_eq(WITH_MESSAGE("all seeds of this class follow from SEED=5",
                              class_keys_make(".", &five, grader, contents)),
                 0);
    fclose(contents);
    FILE *file = fopen("keys", "r");
    cr_assert_not_null(file);
    while (keys.n < MANY && fscanf(file, "%*s %*s %" SCNu64, &keys.seeds[keys.n]) == 1) {
        keys.n++;
    }
    fclose(file);
    cr_assert_eq(keys.n, n);
    return keys;
}

static int n_common(const Keys *left, const Keys *right)
{
    int n = 0;
    for (int i = 0; i < left->n; i++) {
        for (int k = 0; k < right->n; k++) {
            n += left->seeds[i] == right->seeds[k];
        }
    }
    return n;
}

static int n_different(const Keys *keys)
{
    int n = 0;
    for (int i = 0; i < keys->n; i++) {
        const Keys own = {{keys->seeds[i]}, 1};
        Keys earlier = *keys;
        earlier.n = i;
        n += n_common(&earlier, &own) == 0;
    }
    return n;
}

Test(class_keys, a_round_has_sixteen_seeds_and_the_next_has_others)
{
    const Keys first = keys_of(0, MANY, 'a', "grader");
    cr_expect_eq(n_different(&first), 16);
    const Keys second = keys_of(0, MANY, 'b', "grader");
    cr_expect_eq(n_different(&second), 16);
    cr_expect_eq(n_common(&first, &second), 0);
    int n_shared = 0;
    for (int i = 1; i < MANY; i++) {
        n_shared += first.seeds[i] == first.seeds[0] && second.seeds[i] == second.seeds[0];
    }
    cr_expect_lt(n_shared, 8, "who shares a seed is drawn anew: found %d of %d", n_shared, MANY);
}

Test(class_keys, what_has_not_changed_keeps_its_seed)
{
    const Keys first = keys_of(0, 3, 'a', "grader");
    const Keys later = keys_of(0, 5, 'a', "another grader");
    cr_expect_arr_eq(first.seeds, later.seeds, 3 * sizeof *first.seeds);
    keys_of(3, 2, 'a', "grader");  // the first three are not here
    const Keys back = keys_of(0, 5, 'a', "grader");
    cr_expect_arr_eq(back.seeds, later.seeds, 5 * sizeof *back.seeds);
}

// The late entry's round must not be one whose reports may be out.
Test(class_keys, a_late_entry_has_a_round_of_its_own)
{
    const Keys first = keys_of(0, MANY - 1, 'a', "grader");
    const Keys late = keys_of(MANY - 1, 1, 'a', "grader");
    cr_expect_eq(n_common(&first, &late), 0);
}

Test(class_keys, a_record_that_is_lost_brings_no_old_seed_back)
{
    const Keys first = keys_of(0, 3, 'a', "grader");
    cr_assert_eq(truncate("rounds", 100), 0);
    const Keys second = keys_of(0, 3, 'b', "grader");
    cr_expect_eq(n_common(&first, &second), 0);
    cr_assert_eq(unlink("rounds"), 0);
    const Keys third = keys_of(0, 3, 'c', "grader");
    cr_expect_eq(n_common(&first, &third) + n_common(&second, &third), 0);
}

// Worked out by another program: Python's hmac.
Test(class_secret, a_seed_is_an_hmac)
{
    const ClassSecret secret = {"SEED=5"};
    cr_expect_eq(class_secret_seed(&secret, "round", "slug"), 15929970079701499550u);
}

Test(class_keys, what_is_no_list_of_contents_is_refused)
{
    FILE *contents = tmpfile();
    fputs("a-slug-alone\n", contents);
    rewind(contents);
    cr_expect_eq(
        WITH_MESSAGE("expected a slug and a hash", class_keys_make(".", NULL, "grader", contents)),
        -1);
    cr_expect_eq(access("keys", F_OK), -1);
    fclose(contents);
}
