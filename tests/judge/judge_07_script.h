// The scripted world, on which lab 07's trace is tried alone: what a ray finds at a node is drawn
// by lot by the stand-ins of tests/stand_ins/07-kdtree-3d-trace/, and has little to do with where
// planes and spheres are. All distances are small whole numbers, so that a search is foreseen to
// the bit.
//
// - The camera stands at whole numbers and looks along -z through a narrow display: times 4096, the
//   first two coordinates of a pixel's direction are half a whole number, whichever way float
//   rounds. So a stand-in knows the pixel by the direction, or by one over it.
// - The part of a ray inside the tree's box goes from a whole number, box.min[0] or a little more,
//   to another; t_split lies between the two, or on them.
// - Sphere i is hit at the distance spheres[i].radius; no two have the same. A leaf gives one of
//   its spheres or none: hits lie before, at and beyond t_max, and in a later leaf nearer ones.
// - n_spheres of an inner node holds a table for near_side: bit e for an eye at e on the node's
//   axis, 8 + e where the ray goes up that axis. It is true: who compares with the plane finds the
//   same. Bit 16 says that every ray meets both children.
#ifndef GRADER_JUDGE_07_SCRIPT_H
#define GRADER_JUDGE_07_SCRIPT_H

#include "job_scene3d.h"
#include "random.h"
#include "work.h"

enum {
    SCRIPTED_RANDOM = 0,  // six trees of more and more levels
    SCRIPTED_EDGES = 6,   // a leaf, an empty one, eyes on planes, no spheres, as deep as may be
    N_SCRIPTED = SCRIPTED_EDGES + 7,
};

// Draw the scenes, with their trees and expected pictures. Returns 0, or -1 after one message.
int scripted_07_draw(Random *random, JobScene3D scenes[N_SCRIPTED]);

// What a right search of the scripted world finds, and what it costs.
typedef struct ScriptedSearch {
    float t;      // INFINITY when nothing is hit
    u32 sphere;   // ORACLE_NO_SPHERE when nothing is hit
    Work work;    // n_leaves_visited with the empty ones, which need not be searched
    u32 n_empty;  // of these
} ScriptedSearch;

ScriptedSearch scripted_07_search(const JobScene3D *scene, int x, int y);

#endif
