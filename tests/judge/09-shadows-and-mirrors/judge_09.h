// What lab 09's judge asks of a submission: inputs of its functions, and scenes with their trees,
// each with a number of mirrors that a ray meets at most. Starts of new rays are rolled and judged
// in judge_09_starts.c, their directions in judge_09_rays.c, leaves in judge_09_leaves.c and
// judge_09_leaf.c, lights in judge_09_lit.c and judge_09_lights.c, the scenes in
// judge_09_scenes.c, their pictures in judge_09_pictures.c, the rays that are sent in
// judge_09_sent.c, one answer alone in judge_09_alone.c.
#ifndef JUDGE_JUDGE_09_H
#define JUDGE_JUDGE_09_H

#include "job_scene3d.h"
#include "jobs_09.h"
#include "judge.h"
#include "oracle3d_mirrors.h"

// ---- Functions --------------------------------------------------------------------------------

// How many inputs are what whole pictures send (judge_09_calls.c): the first ones of a function; of
// lit_color those of its last range.
enum { N_SENT_CALLS = 200, N_SENT_BLOCKS = 100, N_SENT_LITS = 100 };

// How many inputs each range has; a function's ranges follow one another.
enum {
    N_START_INPUTS = N_SENT_CALLS + 300,   // 2 ranges: numbers of usual size, and of any
    N_MIRROR_INPUTS = N_SENT_CALLS + 300,  // 2: at random, and along axes, head-on and grazing
    N_SHADOW_RAY_INPUTS = N_SENT_CALLS + 400,
    N_BLOCK_INPUTS = N_SENT_BLOCKS + 400,  // 2: at random, and at the ends of the ray
    N_LIT_INPUTS = N_SENT_LITS + 300,      // 3: one light, lights behind the surface, several
    N_BLOCKS = 2 * N_BLOCK_INPUTS,
    N_LITS = 3 * N_LIT_INPUTS,
    BLOCK_MAX_SPHERES = 8,
    // The last leaf of the first range is longer than 8 bits count, and its last sphere blocks. Its
    // ids and their places are beyond 16 bits; what these hold of them is nobody's.
    LONG_LEAF = N_BLOCK_INPUTS - 1,
    N_LONG_LEAF = 300,
    FIRST_LONG_ID = 5 << 14,
    N_BLOCK_ENDS = 6,  // the last leaves of the second range: a hit at the end itself, or just not
    // Before and behind each leaf's ids stands one more, which must not be asked.
    N_SHORT_BLOCK_IDS = N_BLOCKS * (BLOCK_MAX_SPHERES + 2),
    N_BLOCK_IDS = FIRST_LONG_ID + N_LONG_LEAF + 2,
    N_DRAWN_LIGHTS = 320,
    N_DIM_LITS = 2,      // the last ones of the first range,
    N_GRAZING_LITS = 4,  // and of the second one: each with a light that is placed
    N_PLACED_LITS = N_DIM_LITS + N_GRAZING_LITS,
    N_SENT_LIGHTS = 200,  // of the scenes
    N_LIT_LIGHTS = N_DRAWN_LIGHTS + N_PLACED_LITS + 1 + N_SENT_LIGHTS,
    N_EDGE_LITS = 8,          // the last ones of several lights: none, and many,
    MOST_LIT_LIGHTS = 300,    // the last one of all
    MOST_ALONE_LIGHTS = 4,    // of one input of lit_color that is tried alone,
    MANY_ALONE_LIGHTS = 300,  // and of the last one
};

// How much larger or smaller than usual an input is: a power of two from 2^-20 to 2^20.
float random_power_09(Random *random);

// How dark a light is, or how little a surface scatters, where the other makes up for it: a power
// of two, so that nothing is rounded.
#define DIM 0x1p-20f

// A vector of length |x| along axis 0, 1 or 2.
Vec3 along_09(int axis, float x);

// A colour for light number i. One in five is all red, green or blue, so that no colour by itself
// says whether a light gives anything.
Vec3 light_09_color(Random *random, int i);

// Which input of lit_color is number k of those with a light that is placed?
int lit_09_placed(int k);

// Place the light of that input, whose point and material are set: dark, on a surface that scatters
// little, or grazing it, from before or behind, and as bright as that needs to be seen.
void lit_09_place(LitJob *job, Light *light, int k);

// Are of input i of lit_color the rays judged only? There lights are on both sides, and what comes
// of several is judged elsewhere.
int lit_09_counts_only(int i);

extern const Function start_09, mirror_09, ray_origin_09, ray_direction_09, ray_end_09;
extern const Function block_09, block_early_09;
extern const Function lit_09;

// A number a hair off is one that was compared or moved by an epsilon.
#define HAIR 0x1p-13f
// Not much more than float may be off with where a ray meets a sphere.
#define LEAST_HAIR 0x1p-16f

// ---- Scenes -----------------------------------------------------------------------------------

// In the order of the job; the first one is LIT_SCENE.
enum {
    LOCAL = 0,  // no mirrors
    N_LOCAL = 5,
    MIRRORS = LOCAL + N_LOCAL,  // one or two
    N_MIRRORS = 5,
    ENDS = MIRRORS + N_MIRRORS,  // up to seven, and once many; cut-offs, ks of 0 and 1
    N_ENDS = 11,
    BACKGROUNDS = ENDS + N_ENDS,  // one material in four has light of its own
    N_BACKGROUNDS = 3,
    N_SCENES = BACKGROUNDS + N_BACKGROUNDS,
    N_SENT_SCENES = 4,  // whose rays are counted
};

typedef struct MirrorScene {
    JobScene3D base;
    i32 max_bounces;
    u32 nonce;  // of the stubs, where an answer is tried alone
} MirrorScene;

// Roll the scenes, with their trees and what is expected. Returns 0, or -1 after one message.
int roll_scenes_09(Random *random, MirrorScene scenes[N_SCENES]);

// Let the oracle draw what is expected. Returns 0, or -1 after one message.
int picture_09_expect(MirrorScene *scene);

// Write scene K. Returns 0, or -1.
int scene_09_write(const MirrorScene *scene, int k, FILE *file);

// ---- Rays that are sent -----------------------------------------------------------------------

// Are the rays of scene k counted? Its tree is one leaf then.
int sent_09_is_counted(int k);

// Are no more rays sent than a right solution sends, in number i of these scenes?
Verdict judge_sent_09(const void *job, int i, const Sections *answers);

// And beside the stubs?
int sent_alone_09(const void *job, int i, const Sections *answers);

// ---- The job ----------------------------------------------------------------------------------

typedef struct Job09 {
    Job job;
    StartJob starts[2 * N_START_INPUTS];
    MirrorJob mirrors[2 * N_MIRROR_INPUTS];
    ShadowRayJob shadow_rays[N_SHADOW_RAY_INPUTS];
    BlockJob blocks[N_BLOCKS];
    u32 block_ids[N_BLOCK_IDS];
    // As many as there are ids: who takes a position for an id finds another sphere.
    Sphere block_spheres[N_BLOCK_IDS];
    LitJob lits[N_LITS];
    Light lit_lights[N_LIT_LIGHTS];
    LitJob alone_lits[N_LITS];
    Light alone_lights[N_LITS * (MOST_ALONE_LIGHTS + 1) +
                       MANY_ALONE_LIGHTS];  // behind those of each one that is not
    MirrorScene scenes[N_SCENES];
} Job09;

void roll_starts_09(Random *random, Job09 *job);
void roll_rays_09(Random *random, Job09 *job);
void roll_blocks_09(Random *random, Job09 *job);
void roll_lits_09(Random *random, Job09 *job);  // the scenes are rolled already

// Put what the kernel sends for whole pictures among them.
void add_calls_09(Random *random, Job09 *job);

// ---- Alone ------------------------------------------------------------------------------------

void roll_alone_09(Random *random, Job09 *job);

// See judge.h.
int write_alone_09(const void *job, const char *task, FILE *file);

// Beside the stubs: is lit_color right for every light, and does it leave those alone that are
// behind the surface? Is the picture of scene K right?
int lits_alone_09(const void *job, const JudgeCheck *check, const Sections *answers);

// Do the stubs say that something is between a point and a light?
//   way   from the one to the other
int is_blocked_alone_09(Vec3 point, Vec3 way, u32 nonce);
int picture_alone_09(const void *job, int k, const Sections *answers);

// What picture K should be there, and the known mistakes. As ExpectAlone has it.
int picture_09_expect_alone(const void *job, int k, ExpectedPicture *expected);

// See alone_cause of judge.h.
Cause picture_cause_09(const void *job, const JudgeCheck *check, const Sections *answers);

#endif
