// The pictures of the 3D bench (see pictures3d.h).
//
// Read next: bench3d.c.
#include "pictures3d.h"

#include "complain.h"
#include "launch.h"
#include "same_pictures.h"

#include <stdio.h>
#include <string.h>

// Colours that no 8-bit picture tells apart are equal: half a step of 255. Hits lie up to 5 away,
// where float's last place is 5e-7; over the smallest radius of the bench's scenes, 0.002, that
// turns a normal by 2.5e-4, which is a fraction of this.
#define COLOUR_TOLERANCE (0.5f / 255)

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
static int check_drawn(const Case3D *bench_case, Renderer renderer, int n_drawn, int n_expected)
{
    if (n_drawn == n_expected) {
        return 0;
    }
    complain("bench3d: %s, %s: found %d pixels drawn, expected %d", bench_case->scene_name,
             RENDERER_NAMES[renderer], n_drawn, n_expected);
    return -1;
}

// Compare the kd-tree's picture with another renderer's. Returns 0, or -1 after one message.
static int check_different(const Pictures3D *pictures, const Case3D *bench_case, Renderer other,
                           float tolerance, int n_compared, Measurements *measurements)
{
    char names[128];
    snprintf(names, sizeof names, "bench3d: %s, %s beside kd-tree", bench_case->scene_name,
             RENDERER_NAMES[other]);
    // Even of a small share one pixel may be ambiguous.
    const int most = 1 + (int)(MAX_AMBIGUOUS_SHARE * n_compared);
    const int n_different = pictures_compare(&pictures->images[other], &pictures->images[KDTREE],
                                             tolerance, most, names);
    if (n_different < 0) {
        return -1;
    }
    measurements_add(measurements, bench_case->scene_name, RENDERER_NAMES[other], "different",
                     n_different);
    return 0;
}

int pictures3d_check(Pictures3D *pictures, const Case3D *bench_case, Measurements *measurements)
{
    Image *naive = &pictures->images[NAIVE], *kdtree = &pictures->images[KDTREE];
    const int n_naive = case3d_share_pixels(bench_case);
    if (check_drawn(bench_case, KDTREE, count_drawn(kdtree), N_PIXELS) != 0 ||
        check_drawn(bench_case, BY_COST, count_drawn(&pictures->images[BY_COST]), N_PIXELS) != 0 ||
        check_drawn(bench_case, NAIVE, count_drawn(naive), n_naive) != 0) {
        return -1;
    }
    complete(naive, kdtree);
    if (check_different(pictures, bench_case, NAIVE, COLOUR_TOLERANCE, n_naive, measurements) !=
            0 ||
        check_different(pictures, bench_case, BY_COST, COLOUR_TOLERANCE, N_PIXELS, measurements) !=
            0) {
        return -1;
    }
    for (int call = 0; call < N_EMBREE_CALLS && pictures->has_embree; call++) {
        if (embree_peer_has(call) &&
            check_different(pictures, bench_case, EMBREE + call, COLOUR_TOLERANCE, N_PIXELS,
                            measurements) != 0) {
            return -1;
        }
    }
    // The last: nothing else is compared with the kd-tree's picture.
    round_to_bytes(kdtree);
    return check_different(pictures, bench_case, TILES, BYTE_TOLERANCE, N_PIXELS, measurements);
}
