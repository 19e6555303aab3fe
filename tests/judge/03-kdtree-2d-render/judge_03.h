// What lab 03's judge asks of a submission: inputs of getContainingChild, and scenes with their
// trees. Rolled in judge_03_job.c, judge_03_trees.c and judge_03_families.c, judged in judge_03.c
// and judge_03_work.c; answers are tried alone in judge_03_alone.c.
#ifndef JUDGE_JUDGE_03_H
#define JUDGE_JUDGE_03_H

#include "job_scene.h"
#include "jobs_03.h"
#include "judge.h"

// The scenes.
enum {
    RANDOM = 0,   // two
    BORDERS = 2,  // root [0, 256] x [0, 256]: splits fall on whole pixels
    WIDE = 3,
    WITHIN = 4,  // smaller than its picture: pixels outside the root
    ORDER = 5,
    EDGES = 6,
    EMPTY_LEAVES = EDGES + 1,
    ROOT_IS_LEAF = EDGES + 4,
    DEPTHS = EDGES + 6,
    LONG_LIST = EDGES + 7,
    N_EDGES = 8,
    LEAF_MAP = EDGES + N_EDGES,  // each leaf has a colour of its own,
    STAIRS = LEAF_MAP + 1,       // and here the tree is deeper than any number one might think of
    N_SCENES = STAIRS + 1,
};

// No tree of a leaf map has more levels.
enum { MOST_LEVELS = 302 };

// Where ids are high: what 16 or 8 bits hold of them is the id of a node that is nobody's.
enum { FAR_IDS = (1 << 16) + 64 };

// Inputs of getContainingChild: first families that are nobody's, in either direction, each with
// the pixels before, at and behind a border, and one on either side outside the cell; then random
// ones, and what the kernel sends for every pixel of every picture: a node whose left child it is
// in, and one whose right child.
enum { N_FAMILIES = 17, N_FAMILY_PIXELS = 5, N_FAMILY_JOBS = 2 * N_FAMILY_PIXELS * N_FAMILIES };
enum { N_FAMILY_NODES = 3 * 2 * N_FAMILIES };
enum { WIDE_COLUMNS = 317, WIDE_ROWS = 100, BORDERS_SIDE = 256 };
enum {
    N_OTHER_PIXELS = 45000,  // at most
    N_SENT_INSIDE = 2 * (WIDE_COLUMNS * WIDE_ROWS + BORDERS_SIDE * BORDERS_SIDE + N_OTHER_PIXELS),
    N_SENT_BORDER = 20,  // by each scene
};
enum { N_ROLLED_INSIDE = 2000, N_ROLLED_BORDER = 1000 };
enum { N_INSIDE = N_ROLLED_INSIDE + N_SENT_INSIDE };
enum { N_BORDER = N_ROLLED_BORDER + N_SENT_BORDER * N_SCENES };
enum { N_CHILDREN = N_INSIDE + N_BORDER };

typedef struct Job03 {
    Job job;
    ChildJob children[N_CHILDREN];
    KdTree2D
        child_tree;  // of these: nodes of BORDERS, families that are nobody's, all scenes' trees
    JobScene scenes[N_SCENES];
} Job03;

// See judge.h.
int roll_job_03(void *job, Random *random);
void job_03_release(void *job);
int job_03_write_scene(const void *job, int k, FILE *file);

// Do the counted calls of getContainingChild and of overlaps_N_Nearer fit the way to the leaf, and
// its list?
Verdict judge_descent_work_03(const void *job, const Sections *answers);
Verdict judge_leaf_work_03(const void *job, const Sections *answers);

// One answer alone.
int write_alone_03(const void *job, const char *task, FILE *file);
int ends_in_leaves_03(const void *job, int k, const Sections *answers);

Cause descent_cause_03(const void *job, const JudgeCheck *check, const Sections *answers);

// How the search in a leaf map went wrong, if each pixel's ended where a known mistake ends.
//   ends[height * width]   the node in which it ended
Cause ends_look_03(const JobScene *scene, const u32 *ends);

// A tree with room for that many nodes and entries, all zeros. Returns 0, or -1 after one message;
// to be freed in either case.
int tree_create_03(u32 n_nodes, u32 n_map, KdTree2D *tree);

// Make the scene's tree a leaf map, with the picture that is expected; all its nodes but the root
// get ids above first_id. Outside the root a pixel may end in any leaf. Returns 0, or -1 after one
// message.
int make_leaf_map(JobScene *scene, u32 first_id);

// Of a wrong leaf map: where the search of the first wrong pixel ended, if its colour is a node's,
// "at pixel (9, 0) your search ends in node 35, expected 51". Owned by the caller; or NULL.
char *first_wrong_end_03(const JobScene *scene, int k, const Sections *answers);

// Roll the scene STAIRS. Returns 0, or -1 after one message.
int draw_stairs(JobScene *scene);

// Add families whose borders are beside a whole pixel or at negative coordinates, from FAR_IDS on;
// and the inputs that ask for these.
void add_families(KdTree2D *more, ChildJob jobs[N_FAMILY_JOBS]);

// Add the nodes of the scenes' trees, from id `first` on, and the calls that the pictures send.
void add_sent_03(Random *random, const JobScene scenes[N_SCENES], u32 first, KdTree2D *more,
                 ChildJob inside[N_SENT_INSIDE], ChildJob border[N_SENT_BORDER * N_SCENES]);
u32 count_sent_nodes_03(const JobScene scenes[N_SCENES]);

// Write the nodes of getContainingChild. Returns 0, or -1.
int write_child_tree_03(const Job03 *job, FILE *file);

// Is the point in the cell? Cells are half-open: minX <= x < maxX.
int cell_holds(BBox2D box, double x, double y);

// The leaf below the root whose cell holds the point; the number of nodes when none does.
u32 leaf_at(const KdTree2D *tree, int x, int y);

#endif
