// grader/borrowing: an answer that another task's function gives is seen, and no other one is.
// Runs in the course's top folder.
#include "borrowing.h"

#include <criterion/criterion.h>

TestSuite(borrowing);

// What the answer to a task of a lab borrows: the other task's id, "" for nothing.
static const char *borrowed_from(const Manifest *manifest, const char *task, const char *answer)
{
    const Task *asked = manifest_task(manifest, task);
    cr_assert_not_null(asked, "%s has no task %s", manifest->lab, task);
    const Task *borrowed = borrowed_task(manifest, asked, answer);
    return borrowed ? borrowed->id : "";
}

Test(borrowing, one_way_to_intersect_by_the_other)
{
    Manifest manifest;
    cr_assert_eq(manifest_load("labs", "05-spheres", &manifest), 0);
    static const struct {
        const char *answer, *borrowed;
    } cases[] = {
        {"return intersect_sphere(sphere, ray);", "intersect_sphere"},
        {"return (intersect_sphere)(sphere, ray);", "intersect_sphere"},
        {"// intersect_sphere(sphere, ray)\nreturn \"intersect_sphere\" != 0;", ""},
        {"return hit.intersect_sphere;", ""},
        // Our own answer calls this one, too.
        {"return nearest_root(b, disc, sphere.radius, ray.t_min);", ""},
        // The function itself, and one that is no task's.
        {"return intersect_textbook(sphere, ray) + sqrt(2.0f);", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        cr_expect_str_eq(borrowed_from(&manifest, "intersect_textbook", cases[i].answer),
                         cases[i].borrowed, "%s", cases[i].answer);
    }
    manifest_free(&manifest);
}

// "descent" and "leaf_loop" are parts of one function: as names they mean nothing.
Test(borrowing, tasks_that_are_no_functions)
{
    Manifest manifest;
    cr_assert_eq(manifest_load("labs", "03-kdtree-2d-render", &manifest), 0);
    cr_expect_str_eq(borrowed_from(&manifest, "leaf_loop", "int descent = 0;"), "");
    cr_expect_str_eq(borrowed_from(&manifest, "descent", "id = getContainingChild(x);"), "");
    cr_expect_str_eq(borrowed_from(&manifest, "leaf_loop", "id = getContainingChild(x);"),
                     "getContainingChild");
    manifest_free(&manifest);
}
