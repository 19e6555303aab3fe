// What lab 04's judge asks of a submission: views, pixels and pictures of directions. Rolled in
// judge_04_job.c, judged in judge_04_axes.c, judge_04_display.c and judge_04_rays.c, alone in
// judge_04_alone.c.
#ifndef JUDGE_JUDGE_04_H
#define JUDGE_JUDGE_04_H

#include "jobs_04.h"
#include "judge.h"
#include "oracle3d.h"

enum { N_VIEWS = 600, N_PIXELS = 500 };

// Pixels: in square pictures, anywhere, all of the pictures by which the other tasks are judged (so
// that who is wrong in a picture is wrong here, too), and in wide and high pictures. N_SENT is the
// most that the pictures have.
enum {
    SQUARE = 0,
    ANYWHERE = SQUARE + N_PIXELS,
    SENT = ANYWHERE + N_PIXELS,
    N_SENT = 96 * 64 + 49 * 67 + 3 * 48 * 48,
    OBLONG = SENT + N_SENT,
    N_ALL_PIXELS = OBLONG + N_PIXELS,
};

// The last inputs are the same in every job. They come last, so that what is wrong with them only
// is known by that.
enum {
    N_LENGTHS = 6,  // views along long or short vectors,
    N_STEEP = 4,    // then some that look nearly along view.up
    FIRST_STEEP = N_VIEWS - N_STEEP,
    FIRST_LENGTH = FIRST_STEEP - N_LENGTHS,
    N_FAR_EYES = 8,  // pixels
    FIRST_FAR_EYE = N_ALL_PIXELS - N_FAR_EYES,
};

// Two pictures of any camera, then one along each axis.
enum { RANDOM = 0, ALONG = 2, N_PICTURES = ALONG + 3 };

typedef struct Job04 {
    Job job;
    ViewJob views[N_VIEWS];
    PixelJob pixels[N_ALL_PIXELS];
    SceneJob3D scenes[N_PICTURES];
    JobPicture directions[N_PICTURES];
} Job04;

// How far a point on the display may be off, as a share of the display's half width: see
// oracle3d.c.
#define DISPLAY_ERROR_04 (32 * 0x1p-24)

// See judge.h.
int roll_job_04(void *job, Random *random);
int job_04_write_scene(const void *job, int k, FILE *file);

// The picture of the directions of a scene, which must stay where it is. Returns 0, or -1 after one
// message.
int expect_directions_04(const SceneJob3D *scene, ExpectedPicture *expected);

// camera_axes, pixel_on_display and primary_ray: one for each property that is judged.
extern const Function axes_orthonormal_04, axes_forward_04, axes_up_04;
extern const Function display_sides_04, display_04;
extern const Function ray_transform_04, ray_unit_04, ray_limits_04;

// Is a vector as near to the expected one, or to its opposite, in each part?
int is_near_04(Vec3 found, OracleVector expected, double error);
int is_opposite_04(Vec3 found, OracleVector expected, double error);

// One answer alone.
int write_alone_04(const void *job, const char *task, FILE *file);
int are_turned_04(const void *job, const JudgeCheck *check, const Sections *answers);
int is_drawn_04(const void *job, int k, const Sections *answers);
Cause drawn_cause_04(const void *job, const JudgeCheck *check, const Sections *answers);

// What stands in the hole of pixel_on_display then; and the direction of what stands in that of
// primary_ray, as float and as it is.
Vec3 stub_display_04(const PixelJob *in);
Vec3 stub_direction_04(const SceneJob3D *scene, int x, int y);

// Draw a picture of directions with a known mistake, by these. As DrawMistaken has it.
Cause draw_directions_alone_04(const void *scene, int mistake, Image *guess, float *tolerances);

#endif
