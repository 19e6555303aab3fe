// Right answers of lab 08, in plain C: every plane asks every sphere.
//
// The tree grows by lab 06's steps, which the grader has in it. Read next: right_answers.h.
#ifndef UNIT_RIGHT_ANSWERS_SAH_H
#define UNIT_RIGHT_ANSWERS_SAH_H

#include "jobs_08.h"
#include "kdtree3d_build.h"
#include "right_answers_sections.h"
#include "right_answers_tree3d.h"

#include <math.h>

static double area_of(BBox3D box)
{
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    return 2 * x * y + 2 * x * z + 2 * y * z;
}

static double cost_of(CostJob split)
{
    BBox3D lower = split.box, higher = split.box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    const double tests = area_of(lower) * split.n_lower + area_of(higher) * split.n_higher;
    return 1 + 0.5 * tests / area_of(split.box);
}

static BestAnswer best_of(const Sphere *spheres, const u32 *ids, u32 n_ids, BBox3D box)
{
    BestAnswer best = {0, 0, INFINITY};
    for (u32 axis = 0; axis < 3; axis++) {
        for (int i = 1; i < 32; i++) {
            const float side = box.max[axis] - box.min[axis];
            CostJob split = {box, axis, box.min[axis] + side * ((float)i / 32), 0, 0};
            for (u32 j = 0; j < n_ids; j++) {
                const Sphere s = spheres[ids[j]];
                const float centre = axis == 0 ? s.x : axis == 1 ? s.y : s.z;
                split.n_lower += centre - fabsf(s.radius) <= split.pos;
                split.n_higher += centre + fabsf(s.radius) >= split.pos;
            }
            if (cost_of(split) < best.cost) {
                best = (BestAnswer){axis, split.pos, cost_of(split)};
            }
        }
    }
    return best;
}

static int decision_of(LeafCostJob in)
{
    return in.level >= in.maxDepth || in.n_spheres <= (u32)in.targetElementsPerNode ||
           in.best_cost >= 0.5 * in.n_spheres;
}

static void answer_areas_and_costs(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const BBox3D *boxes = sections_find_any(job, "areas", &n_bytes);
    size_t n = n_bytes / sizeof *boxes;
    double *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        answers[i] = area_of(boxes[i]);
    }
    answer(writer, "areas", answers, n * sizeof *answers);
    free(answers);

    const CostJob *splits = sections_find_any(job, "costs", &n_bytes);
    n = n_bytes / sizeof *splits;
    answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        answers[i] = cost_of(splits[i]);
    }
    answer(writer, "costs", answers, n * sizeof *answers);
    free(answers);
}

static void answer_best_splits(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const Sphere *spheres = sections_find_any(job, "best_spheres", &n_bytes);
    const u32 *ids = sections_find_any(job, "best_ids", &n_bytes);
    const BestJob *nodes = sections_find_any(job, "bests", &n_bytes);
    const size_t n = n_bytes / sizeof *nodes;
    BestAnswer *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        answers[i] = best_of(spheres, ids + nodes[i].first_id, nodes[i].n_ids, nodes[i].box);
    }
    answer(writer, "bests", answers, n * sizeof *answers);
    free(answers);
}

static void answer_decisions(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const LeafCostJob *nodes = sections_find_any(job, "decisions", &n_bytes);
    const size_t n = n_bytes / sizeof *nodes;
    i32 *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        answers[i] = decision_of(nodes[i]);
    }
    answer(writer, "decisions", answers, n * sizeof *answers);
    free(answers);
}

// What a node's split needs to know.
typedef struct SahRule {
    const Sphere *spheres;
    KdTreeLimits limits;
} SahRule;

static int choose_sah(const void *pointer, const KdOpenNode *node, KdSplit *split)
{
    const SahRule *rule = pointer;
    const BestAnswer best = best_of(rule->spheres, node->ids, node->n_ids, node->box);
    const LeafCostJob decision = {node->level, node->n_ids, best.cost, rule->limits.maxDepth,
                                  rule->limits.targetElementsPerNode};
    *split = (KdSplit){best.axis, best.pos};
    return !decision_of(decision);
}

static int build_sah(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree)
{
    const SahRule rule = {h_spheres, limits};
    const KdSteps steps = {"right answers",    choose_sah,      &rule,
                           distribute_spheres, pack_leaf_range, fits_todo};
    return tree3d_grow(&steps, h_spheres, n_spheres, spheres_bounds(h_spheres, n_spheres), tree);
}

static void answer_trees_sah(Writer *writer, const Sections *job)
{
    answer_trees_by(writer, job, build_sah);
}

#endif
