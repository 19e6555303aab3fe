// The oracle: an independent brute-force renderer in double precision.
//
// It shares no code with the labs. It checks the solutions, says which pixels are ambiguous (a
// circle's edge within float rounding), and draws wrong pictures on purpose, so that a submission's
// can be recognised: "as if the boundary did not belong to the circle".
#ifndef JUDGE_ORACLE2D_H
#define JUDGE_ORACLE2D_H

#include "circle.h"
#include "image.h"
#include "tree2d.h"

// What is taken for a circle's id in a leaf's list.
typedef enum OracleId {
    ID_LISTED,        // what stands in the list
    ID_PLACE_FROM_0,  // its place in the list, without the count
    ID_PLACE_FROM_1,  // its place with the count, which is at place 0
    ID_PLACE_IN_MAP,  // its place in mapNode2Circles
    ID_BEFORE,        // what stands before it: of the first one, the count
} OracleId;

// Channels of a colour, as bits.
enum { CHANNEL_R = 1, CHANNEL_G = 2, CHANNEL_B = 4, CHANNEL_A = 8 };

// A way of drawing. All zeros is the right one.
typedef struct OracleRules {
    int strict_boundary;   // distance² < radius²
    int later_wins_ties;   // depth <= minDepth
    int ignore_depth;      // the last covering circle wins
    int farthest_wins;     // depth > maxDepth
    int first_wins;        // the first covering circle wins, whatever its depth
    int skip_first;        // the first circle is not asked
    u32 skip_last;         // nor this number at the end
    double sample_offset;  // added to the pixel's coordinates, 0.5 for the pixel's centre
    int diameter;          // the radius taken for a diameter
    double too_far;        // circles of this depth and behind it are never taken; 0: none is
    int first_is_limit;    // nor those of the first circle's depth and behind it
    int negative_is_none;  // what has a negative depth is covered by whatever comes later
    u32 zero_is_none;      // so has what is 0 in these channels
    int clear_is_hidden;   // circles with alpha 0 are never taken
    int ends_at_0;         // none is asked behind one that is taken at depth 0 or less
    int ends_at_miss;      // nor behind one that does not take the pixel
    int covers_all;        // every circle covers every pixel
    int first_is_nobody;   // a pixel of circle 0 is left background
    int all_limit;         // circles that cover nothing lower minDepth, too
    int last_limits;       // minDepth is the depth of the one before, whether that covers or not
    u32 most_asked;        // of the scene, or of a leaf's list, no more than this; 0: all
    int squares;           // circles are squares, as beside the stub of lab 01
    int transposed;        // through a tree only: of a leaf's circles (y, x) is asked
    OracleId id;           // the same
    int first_list;        // the same: every leaf has the list at the start of mapNode2Circles
    int first_ids;         // or its own count, and the ids at the start
    u32 count_is_end;      // the count is taken for the place in mapNode2Circles at which the list
                           // ends: 1, ids stand up to that place, 2, before it
} OracleRules;

// Draw circles into an image of its size.
//   ambiguous   out: [height * width], 1 where a right float renderer may differ; or NULL
void oracle2d_draw(const Circle *circles, int n_circles, const OracleRules *rules, Image *image,
                   unsigned char *ambiguous);

// The same through a tree: a pixel asks the circles of its leaf only, and it is of each leaf's list
// that the first or the last circle may be left out.
//   tolerances   out: [height * width], INFINITY where a circle behind the end would be asked;
//                else left alone
void oracle2d_draw_leaves(const Circle *circles, int n_circles, const KdTree2D *tree,
                          const OracleRules *rules, Image *image, float *tolerances);

// Does the circle cover the point? Exact for the grid scenes.
int oracle2d_covers(Circle circle, double x, double y);

// May float arithmetic, in any order and with or without contraction, say otherwise?
int oracle2d_is_ambiguous(Circle circle, double x, double y);

// Do circle and closed box share a point? By the distance of the centre to the box's four sides,
// not by clamping as the solution does.
int oracle2d_overlaps_box(Circle circle, BBox2D box);

#endif
