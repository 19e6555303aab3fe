// The pictures of the 3D bench (see pictures3d.h).
//
// Read next: report3d.c.
#include "pictures3d.h"

#include "complain.h"
#include "launch.h"

#include <stdio.h>
#include <string.h>

// Colours that no 8-bit picture tells apart are equal: half a step of 255. Hits lie up to 5 away,
// where float's last place is 5e-7; over the smallest radius of the bench's scenes, 0.002, that
// turns a normal by 2.5e-4, which is a fraction of this.
#define COLOUR_TOLERANCE (0.5f / 255)

// The share of pixels that may differ: where a ray grazes a sphere, or meets two at one distance,
// the last place decides what is hit. The naive and the kd-tree kernel share every function but the
// search, and Embree computes nearly as they do: a pixel in 250 000 was the most that was seen.
#define MAX_AMBIGUOUS_SHARE 1e-4

enum { N_PIXELS = CASE3D_SIDE * CASE3D_SIDE };

int pictures3d_create(Pictures3D *pictures)
{
    for (int i = 0; i < N_RENDERERS; i++) {
        if (image_create(CASE3D_SIDE, CASE3D_SIDE, &pictures->images[i]) != 0) {
            return -1;
        }
    }
    return 0;
}

void pictures3d_free(Pictures3D *pictures)
{
    for (int i = 0; i < N_RENDERERS; i++) {
        image_free(&pictures->images[i]);
    }
}

static int is_drawn(const Image *picture, size_t pixel)
{
    return picture->pixels[pixel * IMAGE_CHANNELS] != NEVER_DRAWN;
}

static int count_drawn(const Image *picture)
{
    int n_drawn = 0;
    for (size_t i = 0; i < N_PIXELS; i++) {
        n_drawn += is_drawn(picture, i);
    }
    return n_drawn;
}

// Give every pixel that was not drawn the one of `other`: it then counts as equal.
static void complete(Image *picture, const Image *other)
{
    for (size_t i = 0; i < N_PIXELS; i++) {
        if (!is_drawn(picture, i)) {
            memcpy(picture->pixels + i * IMAGE_CHANNELS, other->pixels + i * IMAGE_CHANNELS,
                   IMAGE_CHANNELS * sizeof(float));
        }
    }
}

// Returns 0, or -1 after one message.
static int check_drawn(const Case3D *bench_case, const char *renderer, int n_drawn, int n_expected)
{
    if (n_drawn == n_expected) {
        return 0;
    }
    complain("bench3d: %s, %s: found %d pixels drawn, expected %d", bench_case->scene_name,
             renderer, n_drawn, n_expected);
    return -1;
}

// Returns 0, or -1 after one message.
static int check_different(const Case3D *bench_case, const char *other, ImageDifference difference,
                           int n_compared)
{
    // Even of a small share one pixel may be ambiguous.
    const int most = 1 + (int)(MAX_AMBIGUOUS_SHARE * n_compared);
    if (difference.n_different <= most) {
        return 0;
    }
    complain("bench3d: %s: found %d of %d pixels different between the kd-tree's picture and %s, "
             "the first at (%d, %d), expected at most %d",
             bench_case->scene_name, difference.n_different, n_compared, other, difference.first_x,
             difference.first_y, most);
    return -1;
}

int pictures3d_check(Pictures3D *pictures, Case3D *bench_case)
{
    Image *naive = &pictures->images[NAIVE], *kdtree = &pictures->images[KDTREE];
    const int n_naive = case3d_share_pixels(bench_case);
    if (check_drawn(bench_case, "kd-tree", count_drawn(kdtree), N_PIXELS) != 0 ||
        check_drawn(bench_case, "naive", count_drawn(naive), n_naive) != 0) {
        return -1;
    }
    complete(naive, kdtree);
    bench_case->naive_difference = image_compare(kdtree, naive, COLOUR_TOLERANCE);
    if (check_different(bench_case, "the naive one", bench_case->naive_difference, n_naive) != 0) {
        return -1;
    }
    if (!pictures->has_embree) {
        return 0;
    }
    bench_case->embree_difference =
        image_compare(kdtree, &pictures->images[EMBREE], COLOUR_TOLERANCE);
    return check_different(bench_case, "Embree's", bench_case->embree_difference, N_PIXELS);
}
