// Embree on a scene of the course (see embree_peer.h).
//
// Read next: square_rays.h, bench3d.c.
#include "embree_peer.h"

#ifdef WITH_EMBREE

#include "complain.h"
#include "embree_api.h"
#include "square_rays.h"
#include "stats.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

// Rows that a thread takes at once: few, so that the threads end together.
enum { ROWS_AT_ONCE = LARGEST_SIDE, MAX_THREADS = 256 };

const char *embree_peer_version(void)
{
    return RTC_VERSION_STRING;
}

static void report(void *user, enum RTCError code, const char *text)
{
    (void)user;
    complain("Embree: error %d: %s", (int)code, text);
}

// The spheres as Embree's own geometry. Returns 0, or -1 after Embree's message.
static int add_spheres(EmbreePeer *peer)
{
    const Scene3D *scene = peer->scene;
    RTCGeometry geometry = rtcNewGeometry(peer->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    Sphere *vertices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                sizeof *vertices, (size_t)scene->n_spheres);
    for (int i = 0; vertices != NULL && i < scene->n_spheres; i++) {
        vertices[i] = scene->spheres[i];
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(peer->embree_scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(peer->embree_scene);
    return rtcGetDeviceError(peer->device) == RTC_ERROR_NONE ? 0 : -1;
}

EmbreePeer *embree_peer_new(const Scene3D *scene, int n_threads, double *build_ms)
{
    EmbreePeer *peer = calloc(1, sizeof *peer);
    char settings[32];
    if (peer == NULL) {
        fprintf(stderr, "Embree: no memory\n");
        return NULL;
    }
    snprintf(settings, sizeof settings, "threads=%d", n_threads);
    peer->scene = scene;
    peer->camera = camera_from_view(scene->view, scene->width, scene->height);
    peer->n_threads = n_threads < MAX_THREADS ? n_threads : MAX_THREADS;
    peer->device = rtcNewDevice(settings);
    rtcSetDeviceErrorFunction(peer->device, report, NULL);
    peer->embree_scene = rtcNewScene(peer->device);
    const double start = stats_clock_ms();
    if (add_spheres(peer) != 0) {
        embree_peer_free(peer);
        return NULL;
    }
    *build_ms = stats_clock_ms() - start;
    return peer;
}

void embree_peer_free(EmbreePeer *peer)
{
    if (peer != NULL) {
        rtcReleaseScene(peer->embree_scene);
        rtcReleaseDevice(peer->device);
        free(peer);
    }
}

void embree_peer_run(const EmbreePeer *peer, void *work(void *shared), void *shared)
{
    pthread_t threads[MAX_THREADS];
    int n_started = 0;
    while (n_started < peer->n_threads - 1 &&
           pthread_create(&threads[n_started], NULL, work, shared) == 0) {
        n_started++;
    }
    work(shared);
    for (int i = 0; i < n_started; i++) {
        pthread_join(threads[i], NULL);
    }
}

// ---- Search ---------------------------------------------------------------------------------

static inline struct RTCRayHit query_of(Vec3 eye, const Rays *rays, int i)
{
    return (struct RTCRayHit){.ray = {.org_x = eye.x,
                                      .org_y = eye.y,
                                      .org_z = eye.z,
                                      .dir_x = rays->x[i],
                                      .dir_y = rays->y[i],
                                      .dir_z = rays->z[i],
                                      .tfar = INFINITY,
                                      .mask = 0xffffffffu,
                                      .id = (unsigned)i},
                              .hit = {.primID = NO_SPHERE, .geomID = RTC_INVALID_GEOMETRY_ID}};
}

static inline void search_1(const EmbreePeer *peer, Rays *rays)
{
    struct RTCRayHit query = query_of(peer->camera.eye, rays, 0);
    NearestHints hints = nearest_hints(COHERENT);
    rtcIntersect1(ARGUMENTS(peer, &hints, &query));
    rays->t[0] = query.ray.tfar;
    rays->ids[0] = query.hit.primID;
}

// The packets: three functions that differ in Embree's names alone.
#define DEFINE_SEARCH(N)                                                                           \
    static inline void search_##N(const EmbreePeer *peer, Rays *rays)                              \
    {                                                                                              \
        const Vec3 eye = peer->camera.eye;                                                         \
        _Alignas(4 * N) int valid[N];                                                              \
        struct RTCRayHit##N query;                                                                 \
        for (int i = 0; i < N; i++) {                                                              \
            valid[i] = -1;                                                                         \
            query.ray.org_x[i] = eye.x;                                                            \
            query.ray.org_y[i] = eye.y;                                                            \
            query.ray.org_z[i] = eye.z;                                                            \
            query.ray.dir_x[i] = rays->x[i];                                                       \
            query.ray.dir_y[i] = rays->y[i];                                                       \
            query.ray.dir_z[i] = rays->z[i];                                                       \
            query.ray.tnear[i] = query.ray.time[i] = 0;                                            \
            query.ray.tfar[i] = INFINITY;                                                          \
            query.ray.mask[i] = 0xffffffffu;                                                       \
            query.ray.id[i] = query.ray.flags[i] = 0;                                              \
            query.hit.primID[i] = NO_SPHERE;                                                       \
            query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;                                         \
        }                                                                                          \
        NearestHints hints = nearest_hints(COHERENT);                                              \
        rtcIntersect##N(valid, ARGUMENTS(peer, &hints, &query));                                   \
        for (int i = 0; i < N; i++) {                                                              \
            rays->t[i] = query.ray.tfar[i];                                                        \
            rays->ids[i] = query.hit.primID[i];                                                    \
        }                                                                                          \
    }
DEFINE_SEARCH(4)
DEFINE_SEARCH(8)
DEFINE_SEARCH(16)

#if WITH_EMBREE == 3
static inline void search_stream(const EmbreePeer *peer, Rays *rays)
{
    struct RTCRayHit queries[MAX_SQUARE];
    for (int i = 0; i < MAX_SQUARE; i++) {
        queries[i] = query_of(peer->camera.eye, rays, i);
    }
    NearestHints hints = nearest_hints(COHERENT);
    rtcIntersect1M(ARGUMENTS(peer, &hints, queries), MAX_SQUARE, sizeof *queries);
    for (int i = 0; i < MAX_SQUARE; i++) {
        rays->t[i] = queries[i].ray.tfar;
        rays->ids[i] = queries[i].hit.primID;
    }
}
#else
#define search_stream NULL
#endif

static const struct CallRow {
    Square square;  // of pixels whose rays are searched in one call
    void (*search)(const EmbreePeer *peer, Rays *rays);  // or NULL
} CALLS[N_EMBREE_CALLS] = {
    [EMBREE_1] = {{1, 1}, search_1},
    [EMBREE_4] = {{2, 2}, search_4},
    [EMBREE_8] = {{4, 2}, search_8},
    [EMBREE_16] = {{4, 4}, search_16},
    [EMBREE_STREAM] = {{LARGEST_SIDE, LARGEST_SIDE}, search_stream},
};

int embree_peer_has(EmbreeCall call)
{
    return CALLS[call].search != NULL;
}

// ---- Frames ---------------------------------------------------------------------------------

// What the threads of one frame share.
typedef struct Frame {
    const EmbreePeer *peer;
    EmbreeCall call;
    Image *image;
    atomic_int next_row;
} Frame;

// Rays, search and colours of a band of rows. Compiled once for each call, with loops of a known
// length.
static inline __attribute__((always_inline)) void draw_band(const Frame *frame, int first,
                                                            EmbreeCall call)
{
    const Square square = CALLS[call].square;
    const int n = square.width * square.height, width = frame->image->width;
    for (int y = first; y < first + ROWS_AT_ONCE; y += square.height) {
        for (int x = 0; x < width; x += square.width) {
            Rays rays;
            f32 colors[3][MAX_SQUARE];
            rays_create(&frame->peer->camera, x, y, square, frame->image, &rays);
            CALLS[call].search(frame->peer, &rays);
            colors_create(frame->peer->scene, frame->peer->camera.eye, &rays, n, colors);
            for (int i = 0; i < n; i++) {
                const int to_x = x + i % square.width, to_y = y + i / square.width;
                float *pixel = frame->image->pixels +
                               ((size_t)to_y * (size_t)width + (size_t)to_x) * IMAGE_CHANNELS;
                pixel[0] = colors[0][i];
                pixel[1] = colors[1][i];
                pixel[2] = colors[2][i];
                pixel[3] = 1;
            }
        }
    }
}

static void *draw_rows(void *shared)
{
    Frame *frame = shared;
    for (;;) {
        const int first = atomic_fetch_add(&frame->next_row, ROWS_AT_ONCE);
        if (first >= frame->image->height) {
            return NULL;
        }
        switch (frame->call) {
        case EMBREE_4:
            draw_band(frame, first, EMBREE_4);
            break;
        case EMBREE_8:
            draw_band(frame, first, EMBREE_8);
            break;
        case EMBREE_16:
            draw_band(frame, first, EMBREE_16);
            break;
        case EMBREE_STREAM:
            draw_band(frame, first, EMBREE_STREAM);
            break;
        default:
            draw_band(frame, first, EMBREE_1);
        }
    }
}

void embree_peer_draw(const EmbreePeer *peer, EmbreeCall call, Image *image)
{
    Frame frame = {.peer = peer, .call = call, .image = image};
    embree_peer_run(peer, draw_rows, &frame);
}

#else

#include <stddef.h>

const char *embree_peer_version(void)
{
    return NULL;
}

int embree_peer_has(EmbreeCall call)
{
    (void)call;
    return 0;
}

EmbreePeer *embree_peer_new(const Scene3D *scene, int n_threads, double *build_ms)
{
    (void)scene, (void)n_threads, (void)build_ms;
    return NULL;
}

void embree_peer_free(EmbreePeer *peer)
{
    (void)peer;
}

void embree_peer_draw(const EmbreePeer *peer, EmbreeCall call, Image *image)
{
    (void)peer, (void)call, (void)image;
}

#endif
