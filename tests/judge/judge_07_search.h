// Searching a scene's kd-tree on the host, in double precision and independently of lab 07: with
// known mistakes, so that a submission's hits can be recognised, and as wastefully and as sparingly
// as a right solution in float may ever be.
#ifndef GRADER_JUDGE_07_SEARCH_H
#define GRADER_JUDGE_07_SEARCH_H

#include "job_scene3d.h"
#include "work.h"

// A way of searching. All zeros is the right one.
typedef struct SearchRules {
    int far_first;           // near and far child are swapped
    int side_by_direction;   // the near child by the direction, wherever the eye is
    int behind_is_crossed;   // a plane behind the eye counts as crossed before the node is entered
    int far_dropped;         // where both children are met the far one never waits; or the search
                             // ends at the first leaf
    int far_alone_is_near;   // where the far child alone is met the search goes to the near one
    int far_always_waits;    // where the near child alone is met the far one waits besides
    int near_never_skipped;  // where the far child alone is met the near one comes before it
    int near_keeps_t_max;    // the near child does not end at the plane
    int far_keeps_t_min;     // the far child does not begin there
    int part_kept;           // a node that waited gets the part of the ray of the one before it
    int t_max_kept;          // it gets the end of that part only
    int oldest_first;        // the first that was put on the stack comes from it first
    int ends_at_any_hit;     // also beyond the leaf's part of the ray
    int never_ends;          // before the stack is empty
    int end_inverted;        // at a leaf with no hit in its part of the ray, not at one with a hit
} SearchRules;

typedef struct SearchResult {
    u32 sphere;  // ORACLE_NO_SPHERE when nothing is hit
    double t;    // INFINITY when nothing is hit
    Work work;
} SearchResult;

// Search the scene's tree for what the ray hits.
SearchResult search3d(const JobScene3D *scene, const OracleRay *ray, const SearchRules *rules);

// Between these the work of a right search lies.
typedef struct WorkBounds {
    Work least;  // its leaves are those with spheres: nobody need search an empty one
    Work most;
} WorkBounds;

// The least and the most work that a right solution may do for this ray, whichever way float
// rounds. A solution that asks each sphere of a leaf once, and ends as early as it must, never does
// more; one that does less has not looked where a sphere may be, or hides what it does. No least
// stack depth is known: a stack of one's own is not counted.
WorkBounds search3d_bounds(const JobScene3D *scene, const OracleRay *ray);

#endif
