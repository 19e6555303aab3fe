// Judging a student's 3D kd-tree by its invariants, and against the expected tree.
//
// A packed tree has no cells: they are found anew by walking down the student's own planes from the
// student's own box, so that each function below blames one step of the building and no other.
// Functions return NOTHING_WRONG when all is right, else what is wrong, owned by the caller.
// The arrays are a submission's: every id and range is checked before it is used.
#ifndef JUDGE_TREE3D_JUDGE_H
#define JUDGE_TREE3D_JUDGE_H

#include "judge.h"
#include "oracle_tree.h"
#include "scene3d.h"
#include "tree3d.h"

typedef struct TreeScene3D {
    char title[96];       // "random scene"
    Scene3D scene;        // spheres, and what they look like in the report
    KdTreeLimits limits;  // of its tree
    KdTree3D tree;        // what is expected; no nodes where the builder must refuse
    int is_exact;         // no right solution can have another tree: see tree3d_judge_is_exact()
    int is_tied;          // right solutions may have trees of other depths: costs are equal
} TreeScene3D;

// Such scenes as an array of a job (tree3d_judge_scene.c); they have no JobPicture.
extern const SceneKind tree3d_scene_kind;

// Did the builder give up over scene K?
int tree3d_is_refused(int k, const Sections *answers);

// Where it did not: judge its tree by what the check asks.
Verdict tree3d_judge_built(const TreeScene3D *scene, int k, const JudgeCheck *check,
                           const Sections *answers);

// Add cuts through the first tree and one that is deep. As judge.h has it.
void tree3d_add_pictures(const void *job, const Sections *answers, Result *result);

// The words of a BBox3D: "box x [0, 4] y [0, 2] z [0, 1]".
void tree3d_describe_box(const void *input, char *words, size_t n_bytes);

// ---- One call of a function, and the same in a tree ---------------------------------------------

// May a sphere be in a cell's list, must it, or must it not?
typedef enum SphereInCell { SPHERE_OUTSIDE, SPHERE_EITHER, SPHERE_INSIDE } SphereInCell;

// Both with their boundaries. Where they touch so nearly that double may round either way, either
// answer is right; never so where double is exact, as on all of the job's inputs.
SphereInCell tree3d_judge_sphere(Sphere sphere, BBox3D cell);

// Is this the axis that the cell must be split on?
Diagnosis tree3d_judge_axis(const char *where, BBox3D cell, u32 axis);

// Is this the cell's middle on the axis, as float rounds it? The axis is below 3.
Diagnosis tree3d_judge_middle(const char *where, BBox3D cell, u32 axis, f32 pos);

// Do all right solutions split the cell on the same plane? So it is where float rounds neither its
// sides nor its middle.
int tree3d_judge_is_exact_cell(BBox3D cell);

// What the three above expect, in double precision, rounded to float at the end.
BBox3D tree3d_expected_box(const Sphere *spheres, u32 n_spheres);
u32 tree3d_expected_axis(BBox3D cell);
f32 tree3d_expected_middle(BBox3D cell, u32 axis);

// ---- Whole trees --------------------------------------------------------------------------------

// The root's cell is the scene's box.
Diagnosis tree3d_judge_bounds(const TreeScene3D *scene, const KdTree3D *own);

// Each inner node has its children behind it and halves its cell's longest side; and there are
// about as many of them as there should be, so that this says something.
Diagnosis tree3d_judge_splits(const TreeScene3D *scene, const KdTree3D *own);

// Each leaf lists exactly the spheres that overlap its cell.
Diagnosis tree3d_judge_overlap(const TreeScene3D *scene, const KdTree3D *own);

// Each list ascends and names spheres of the scene; leaves are where the limits say so, and nowhere
// else.
Diagnosis tree3d_judge_lists(const TreeScene3D *scene, const KdTree3D *own);

// Nodes are in breadth-first order without gaps, and so are the leaves' ranges, which ascend; and
// where no right solution can differ, the arrays are the expected ones.
Diagnosis tree3d_judge_packing(const TreeScene3D *scene, const KdTree3D *own);

// The todo stack suffices for a search, and the tree is as deep as it should be, where that is
// certain.
Diagnosis tree3d_judge_depth(const TreeScene3D *scene, const KdTree3D *own);

// Grow scene->tree, of scene number k, by the scene's limits, each step in double precision, and
// see whether it is exact (tree3d_expected.c). Returns 0, or -1 after one message.
int tree3d_expect(TreeScene3D *scene, u32 k, Growth *growth);

// Can no right solution have another tree than scene->tree? So it is where no plane on the way to
// it depends on how float rounds, and no comparison of a sphere with a cell on how double does.
int tree3d_judge_is_exact(const TreeScene3D *scene);

// The probe's answer for scene K as a tree that points into the answers (do not free it). Returns
// 1, or 0 when it is missing or its arrays do not fit together.
int tree3d_judge_answer(int k, const Sections *answers, KdTree3D *own);

#endif
