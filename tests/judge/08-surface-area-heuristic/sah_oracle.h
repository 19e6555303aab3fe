// The surface area heuristic in double precision, by its definition: every plane asks every sphere.
// It shares no code with lab 08. And it errs on purpose, so that a submission can be recognised.
#ifndef JUDGE_SAH_ORACLE_H
#define JUDGE_SAH_ORACLE_H

#include "jobs_08.h"

// As kdtree3d_sah.h of lab 08 has them.
enum { SAH_BINS = 32 };
#define SAH_TRAVERSAL 1.0
#define SAH_TEST 0.5

// How far a right cost may be off, relative to it, where all is computed in float. With u =
// FLT_EPSILON / 2: a side is off by u, an area by 5u, area times count by 6u, their sum by 7u,
// over the cell's area by 13u, the cost by 15u. So 16u.
#define SAH_COST_TOLERANCE (8 * FLT_EPSILON)
// The same of an area: 5u.
#define SAH_AREA_TOLERANCE (3 * FLT_EPSILON)

// What is taken for a box's size.
typedef enum SahMeasure {
    SAH_AREA,
    SAH_EDGES,  // the sum of the twelve
    SAH_VOLUME,
    SAH_SAME,      // every box is as large as every other
    SAH_STAND_IN,  // surface_area() of tests/stand_ins
} SahMeasure;

// A way of weighing and choosing. All zeros is the right one.
typedef struct SahRules {
    // The cost of a split.
    SahMeasure measure;
    int no_traversal;       // the step at the node costs nothing
    int no_test;            // a test costs 1
    int constants_swapped;  // each stands in the other's place
    int no_division;        // by the cell's own measure
    int counts_swapped;     // each child has the other one's spheres
    int lower_only;         // the higher child costs nothing
    int higher_only;
    int shares_of_sum;   // the probabilities are shares of the children's sum
    int no_both;         // and of what meets both, one child is spared
    int higher_is_rest;  // and it is the higher one
    double bonus;        // by which share a split with an empty child is cheaper
    int bonus_of_tests;  // and it is a share of the tests' cost
    int empty_saves_step;
    int none_saves_step;  // only where both children are empty
    int flat_is_missed;   // a child without length along the axis costs nothing
    int lower_uncut;      // the lower child has the cell's box
    int higher_uncut;
    int cut_across_x;
    int one_at_least;    // sphere in each child
    int whole_tests;     // of what is expected
    int all_multiplied;  // both constants multiply what is expected
    int lower_tests;     // a test in the higher child costs 1
    int is_stand_in;     // split_cost() of tests/stand_ins
    u32 lot;             // of the stand-ins: lot.h
    // The best of all planes.
    int last_of_equals;
    double least_gain;   // a plane must be cheaper by more than that
    double least_share;  // and by more than this share of what was best so far
    int nan_is_taken;    // where the cell has no area
    int longest_only;    // only planes across the longest side, the first of equal ones
    int no_y, no_z;      // an axis is left out
    int highest_cost;
    int by_centre;      // a sphere counts where its centre is
    int begin_above;    // one that begins at the plane is not in the lower child
    int end_below;      // one that ends at the plane is not in the higher one
    int signed_radius;  // a negative radius turns the range round
    int without_first;  // the first plane is not asked
    int without_last;   // nor the last one
    int to_border;      // the cell's border behind the last plane is asked, too
    int from_border;    // and the one before the first
    int last_axis;      // each axis begins anew
    int later_axis;     // of equal costs on several axes the last one
    int later_plane;    // and on one axis the last plane
    int stops_rising;   // an axis is left at the first plane that costs more than the one before
    int no_empty;       // planes with nothing in a child are left out
    int below_leaf;     // so are those that cost as much as a leaf, or more
    int begin_in_cell;  // who begins before the cell is not in the lower child
    int ends_late;      // who ends before a plane is in its higher child, and not in the next one's
    int begins_early;   // who begins in the bin behind a plane is in its lower child already
    int begins_late;    // who begins in the bin before a plane is not in its lower child yet
    int ends_early;     // who ends in the bin behind a plane is not in its higher child any more
    int higher_keeps;   // the higher child has all
    int carried_over;   // the bins of an axis begin with what those of the axis before hold
    int rest_is_higher;  // who is not in the lower child is in the higher one, and nobody else
    int all_spheres_id;  // sphere i of the array for sphere ids[i]
} SahRules;

double sah_size(BBox3D box, SahMeasure measure);
double sah_cost(CostJob split, const SahRules *rules);

// A node: the spheres that overlap its cell.
typedef struct SahNode {
    BBox3D box;
    const Sphere *spheres;
    const u32 *ids;                 // [n_ids]
    const unsigned char *may_lack;  // [n_ids], 1 where touching is a matter of rounding; NULL: none
    u32 n_ids;
} SahNode;

// A plane of it, and what it costs: by the contract, and as little and as much as it may cost where
// float or double may round a sphere to either side.
typedef struct SahPlane {
    u32 axis;
    f32 pos;
    double cost, least, most;
} SahPlane;

SahPlane sah_weigh(const SahNode *node, u32 axis, int i, const SahRules *rules);

// The plane to be chosen; its cost is INFINITY where there is none. `least` and `most` are the
// lowest of all planes.
SahPlane sah_best(const SahNode *node, const SahRules *rules);

// Is another plane than the best one as cheap, but for rounding? Then either may be chosen.
int sah_is_tied(const SahNode *node, const SahPlane *best);

// Number of the candidate plane on an axis at this position, or 0 where there is none.
int sah_plane_number(BBox3D box, u32 axis, f32 pos);

#endif
