// The surface area heuristic in double precision, by its definition: every plane asks every sphere.
// It shares no code with lab 08.
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

double sah_area(BBox3D box);
double sah_cost(CostJob split);

// The children's cells.
BBox3D sah_lower(CostJob split);
BBox3D sah_higher(CostJob split);

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

SahPlane sah_weigh(const SahNode *node, u32 axis, int i);

// The plane to be chosen; its cost is INFINITY where there is none. `least` and `most` are the
// lowest of all planes.
SahPlane sah_best(const SahNode *node);

// Is another plane than the best one as cheap, but for rounding? Then either may be chosen.
int sah_is_tied(const SahNode *node, const SahPlane *best);

// Candidate plane number i, rounded as float does; and the number of the candidate at a position,
// or 0 where there is none.
f32 sah_plane_at(BBox3D box, u32 axis, int i);
int sah_plane_number(BBox3D box, u32 axis, f32 pos);

// Where a sphere's centre is on an axis.
f32 sah_centre(Sphere sphere, u32 axis);

#endif
