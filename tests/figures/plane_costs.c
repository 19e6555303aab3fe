// What a pixel is expected to do in the trees of plane_trees.h, for the numbers in the 3D notes.
//
//     plane_costs FILE.json
#include "plane_trees.h"

#include "complain.h"
#include "lab.h"
#include "stats.h"

#include <stdio.h>
#include <stdlib.h>

static void add(Stats *stats, const char *scene, const char *rule, const char *what, double value)
{
    char name[64];
    snprintf(name, sizeof name, "%s.%s.%s", scene, rule, what);
    stats_number(stats, name, value);
}

static const struct NamedRule {
    const char *name;
    PlaneRule rule;
} RULES[] = {
    {"middle", {NO_WEIGHT, NO_WEIGHT}},
    {"middle_stop_area", {NO_WEIGHT, AREA}},
    {"area", {AREA, AREA}},
    {"perimeter", {PERIMETER, PERIMETER}},
    {"perimeter_stop_area", {PERIMETER, AREA}},
};
enum { N_RULES = sizeof RULES / sizeof *RULES };

static void scene_add(Stats *stats, const char *name, int (*open)(Scene2D *))
{
    Scene2D scene;
    require(open(&scene));
    for (int i = 0; i < N_RULES; i++) {
        PlaneTree tree = plane_tree_grow(&scene, RULES[i].rule);
        add(stats, name, RULES[i].name, "steps", tree.steps);
        add(stats, name, RULES[i].name, "tests", tree.tests);
        add(stats, name, RULES[i].name, "sum", tree.steps + tree.tests);
        add(stats, name, RULES[i].name, "line_sum", tree.line_sum);
        add(stats, name, RULES[i].name, "n_leaves", tree.n_leaves);
        plane_tree_free(&tree);
    }
    scene2d_free(&scene);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        complain("usage: plane_costs FILE.json");
        return EXIT_FAILURE;
    }
    Stats stats = {0};
    scene_add(&stats, "random", plane_scene_random);
    scene_add(&stats, "clusters", plane_scene_clusters);
    scene_add(&stats, "lecture", plane_scene_lecture);
    require(stats_report(&stats, argv[1]));
    stats_free(&stats);
    return EXIT_SUCCESS;
}
