// A scene of circles, its picture, and what a probe wrote in its place.
//
// For the tests of judge/picture. Read next: test_picture.c.
#ifndef UNIT_PICTURE_CASE_H
#define UNIT_PICTURE_CASE_H

#include "job_scene.h"
#include "jobs.h"
#include "oracle2d.h"
#include "picture.h"
#include "random.h"
#include "surroundings.h"
#include "told.h"

enum { MAX_SIDE = 96, IMAGE_SIDE = PROBE_IMAGE_SIDE(MAX_SIDE), N_CIRCLES = 24 };

typedef struct Case {
    Circle circles[N_CIRCLES];
    JobScene scene;  // they
    ExpectedPicture expected;
    float own[IMAGE_SIDE * IMAGE_SIDE * IMAGE_CHANNELS];
    ProbeImage probe;
    int width, height;
} Case;

static const OracleRules RIGHT = {0};

// Whole centres, radii with whole points on their boundary, few depths: every mistake shows. The
// first and the last circle are nearest of all and apart.
static inline void circles_draw(Random *random, int width, int height, Circle circles[N_CIRCLES])
{
    for (int i = 0; i < N_CIRCLES; i++) {
        const int is_end = i == 0 || i == N_CIRCLES - 1;
        circles[i] = (Circle){.x = (float)random_integer(random, 0, width - 1),
                              .y = (float)random_integer(random, 0, height - 1),
                              .radius = (float)(is_end ? 5 : 5 * random_integer(random, 1, 3)),
                              .depth = is_end ? 0 : (float)random_integer(random, 1, 4) / 4,
                              .r = (float)random_integer(random, 1, 255) / 255,
                              .g = (float)random_integer(random, 1, 255) / 255,
                              .b = (float)random_integer(random, 1, 255) / 255,
                              .a = 1};
    }
    circles[0].x = circles[0].y = 20;
    circles[N_CIRCLES - 1].x = (float)(width - 21);
    circles[N_CIRCLES - 1].y = (float)(height - 22);
}

static inline float *own_pixel(Case *c, int x, int y)
{
    return c->own + (y * c->probe.image_width + x) * IMAGE_CHANNELS;
}

static const float *reference_pixel(const Case *c, int x, int y)
{
    return c->expected.reference.pixels + (y * c->width + x) * IMAGE_CHANNELS;
}

// Nobody has written anything yet.
static inline void own_clear(Case *c)
{
    for (size_t i = 0; i < sizeof c->own / sizeof *c->own; i++) {
        c->own[i] = UNWRITTEN;
    }
}

// The probe's image shows this picture.
static inline void own_show(Case *c, const Image *picture)
{
    own_clear(c);
    for (int y = 0; y < c->height; y++) {
        memcpy(own_pixel(c, 0, y), picture->pixels + y * c->width * IMAGE_CHANNELS,
               (size_t)c->width * IMAGE_CHANNELS * sizeof(float));
    }
}

// A random scene whose picture is expected and shown.
static inline Case *case_open(int width, int height, uint64_t seed)
{
    Case *c = calloc(1, sizeof *c);
    Random random = {seed};
    circles_draw(&random, width, height, c->circles);
    cr_assert_eq(image_create(width, height, &c->expected.reference), 0);
    oracle2d_draw(c->circles, N_CIRCLES, &RIGHT, &c->expected.reference, NULL);
    c->scene.scene = (Scene2D){c->circles, N_CIRCLES, width, height};
    job_scene_recognise(&c->scene, &c->expected);
    c->width = width, c->height = height;
    c->probe = (ProbeImage){c->own, PROBE_IMAGE_SIDE(width), PROBE_IMAGE_SIDE(height)};
    own_show(c, &c->expected.reference);
    return c;
}

static inline void case_close(Case *c)
{
    expected_picture_free(&c->expected);
    free(c);
}

// What the picture is said to look like; "" when nothing is said.
static const char *looks_of(const Case *c)
{
    static char looks[512];
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_assert_not_null(message);
    cr_expect_not(picture_is_right(c->probe, &c->expected));
    const char *at = strstr(message, " it looks ");
    snprintf(looks, sizeof looks, "%s", at ? at + strlen(" it looks ") : "");
    free(message);
    return looks;
}

#endif
