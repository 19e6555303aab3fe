// count_hits: what the rays of a picture hit, counted three ways.
//
//     count_hits SCENE WxH PICTURE.exr
//
// Prints how many pixels of a picture that lab 07 drew show a sphere, how many rays hit one by the
// double-precision oracle and how many of them are ambiguous, and how many hit a sphere or the
// floor that Haines' sphereflake stands on (z = -0.5, 12 to each side), which this course does not
// draw. Exit status: 0 when picture and oracle agree in every ray that is not ambiguous, else 1; 2
// when something is missing.
#include "camera_from_view.h"
#include "complain.h"
#include "image.h"
#include "oracle3d.h"
#include "scene3d.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define FLOOR_Z (-0.5)
#define FLOOR_SIDE 12.0

typedef struct Counts {
    int in_picture, by_oracle, ambiguous, with_floor;
    int disagree;  // rays of which the picture tells otherwise, ambiguous ones left out
} Counts;

static int is_background(const float *pixel, Vec3 background)
{
    return pixel[0] == background.x && pixel[1] == background.y && pixel[2] == background.z;
}

static int hits_floor(const OracleRay *ray)
{
    const double t = (FLOOR_Z - ray->origin.z) / ray->direction.z;
    return t > 0 && fabs(ray->origin.x + t * ray->direction.x) <= FLOOR_SIDE &&
           fabs(ray->origin.y + t * ray->direction.y) <= FLOOR_SIDE;
}

// The spheres that a row's rays can hit: those that the rays' plane cuts, with half a radius to
// spare, which in the scenes asked for here is far more than rounding can decide. Of a row that is
// one pixel wide, whose plane is unknown, all. Returns how many.
//   kept   out, room for all of the scene's
static u32 keep_near_row(const Scene3D *scene, const OracleRay *first, const OracleRay *last,
                         Sphere *kept)
{
    const OracleVector normal = vector_unit(vector_cross(first->direction, last->direction));
    u32 n_kept = 0;
    for (int i = 0; i < scene->n_spheres; i++) {
        const Sphere sphere = scene->spheres[i];
        const OracleVector centre = {sphere.x, sphere.y, sphere.z};
        const double distance = fabs(vector_dot(vector_minus(centre, first->origin), normal));
        // A sphere that is seen from inside has a negative radius.
        if (!(distance > 1.5 * fabs((double)sphere.radius))) {
            kept[n_kept++] = sphere;
        }
    }
    return n_kept;
}

static Counts count(const Scene3D *scene, const Image *image, Sphere *kept)
{
    const Camera camera = camera_from_view(scene->view, scene->width, scene->height);
    const int width = scene->width, height = scene->height;
    const OracleRules3D right = {0};
    Counts counts = {0};
    for (int y = 0; y < height; y++) {
        const OracleRay first = oracle3d_primary_ray(&camera, 0, y, width, height, &right);
        const OracleRay last = oracle3d_primary_ray(&camera, width - 1, y, width, height, &right);
        const u32 n_kept = keep_near_row(scene, &first, &last, kept);
        for (int x = 0; x < width; x++) {
            const OracleRay ray = oracle3d_primary_ray(&camera, x, y, width, height, &right);
            const OracleHit hit = oracle3d_nearest(kept, n_kept, &ray, &right);
            const size_t offset = ((size_t)y * (size_t)width + (size_t)x) * IMAGE_CHANNELS;
            const int shown = !is_background(image->pixels + offset, scene->background);
            const int is_hit = hit.sphere != ORACLE_NO_SPHERE;
            counts.in_picture += shown;
            counts.by_oracle += is_hit;
            counts.ambiguous += hit.is_ambiguous;
            counts.with_floor += is_hit || hits_floor(&ray);
            counts.disagree += shown != is_hit && !hit.is_ambiguous;
        }
    }
    return counts;
}

int main(int argc, char **argv)
{
    int width, height, status = 2;
    Scene3D scene = {0};
    Image image = {0};
    Sphere *kept = NULL;
    if (argc != 4 || sscanf(argv[2], "%dx%d", &width, &height) != 2) {
        complain("usage: count_hits SCENE WxH PICTURE.exr");
        return 2;
    }
    if (scene3d_open(argv[1], width, height, &scene) == 0 && image_load(argv[3], &image) == 0) {
        kept = malloc(((size_t)scene.n_spheres + 1) * sizeof *kept);
        if (kept == NULL) {
            complain("count_hits: no memory for %d spheres", scene.n_spheres);
        } else if (image.width == width && image.height == height) {
            const Counts counts = count(&scene, &image, kept);
            printf("rays %d\nin the picture %d\nby the oracle %d\nambiguous %d\nwith the floor %d\n"
                   "disagree %d\n",
                   width * height, counts.in_picture, counts.by_oracle, counts.ambiguous,
                   counts.with_floor, counts.disagree);
            status = counts.disagree > 0;
        } else {
            complain("count_hits: %s: found %dx%d, expected %s", argv[3], image.width, image.height,
                     argv[2]);
        }
    }
    free(kept);
    image_free(&image);
    scene3d_free(&scene);
    return status;
}
