// Embree on a scene of the course (see embree_peer.h). Rays and shading follow primary_ray.cl and
// shade.cl, so that both sides do the same work around the search.
//
// Read next: bench3d.c.
#include "embree_peer.h"

#ifdef WITH_EMBREE

#include "camera_from_view.h"
#include "complain.h"
#include "stats.h"

#if WITH_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

// Rows that a thread takes at once: few, so that the threads end together.
enum { ROWS_AT_ONCE = 8, MAX_THREADS = 256 };

struct EmbreePeer {
    const Scene3D *scene;
    Camera camera;
    int n_threads;
    RTCDevice device;
    RTCScene embree_scene;
};

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

static Vec3 plus(Vec3 a, Vec3 b)
{
    return (Vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static Vec3 unit(Vec3 v)
{
    return vec3_scaled(v, 1 / sqrtf(vec3_dot(v, v)));
}

// primary_ray() of lab 04.
static Vec3 direction_of(const Camera *camera, int x, int y, int width, int height)
{
    const f32 pixel_size = camera->fov / (f32)width;
    const f32 right = ((f32)x + 0.5f - 0.5f * (f32)width) * pixel_size;
    const f32 up = (0.5f * (f32)height - ((f32)y + 0.5f)) * pixel_size;
    return unit(plus(plus(vec3_scaled(camera->right, right), vec3_scaled(camera->up, up)),
                     camera->forward));
}

// hit_color() of lab 05.
static Vec3 color_of(const Scene3D *scene, Vec3 origin, Vec3 direction, f32 t, u32 id)
{
    const Sphere sphere = scene->spheres[id];
    const Material material = scene->materials[scene->material_ids[id]];
    const Vec3 point = plus(origin, vec3_scaled(direction, t));
    Vec3 normal = unit(vec3_minus(point, (Vec3){sphere.x, sphere.y, sphere.z}));
    if (vec3_dot(normal, direction) > 0) {
        normal = vec3_scaled(normal, -1);
    }
    Vec3 color = {0, 0, 0};
    for (int i = 0; i < scene->n_lights; i++) {
        const Light light = scene->lights[i];
        const f32 cosine = vec3_dot(normal, unit(vec3_minus(light.position, point)));
        if (cosine > 0) {
            color.x += material.kd * cosine * material.color.x * light.color.x;
            color.y += material.kd * cosine * material.color.y * light.color.y;
            color.z += material.kd * cosine * material.color.z * light.color.z;
        }
    }
    return color;
}

static Vec3 trace(const EmbreePeer *peer, Vec3 origin, Vec3 direction)
{
    struct RTCRayHit query = {.ray = {.org_x = origin.x,
                                      .org_y = origin.y,
                                      .org_z = origin.z,
                                      .dir_x = direction.x,
                                      .dir_y = direction.y,
                                      .dir_z = direction.z,
                                      .tfar = INFINITY,
                                      .mask = 0xffffffffu},
                              .hit = {.geomID = RTC_INVALID_GEOMETRY_ID}};
#if WITH_EMBREE == 4
    rtcIntersect1(peer->embree_scene, &query, NULL);
#else
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(peer->embree_scene, &context, &query);
#endif
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return peer->scene->background;
    }
    return color_of(peer->scene, origin, direction, query.ray.tfar, query.hit.primID);
}

// What the threads of one frame share.
typedef struct Frame {
    const EmbreePeer *peer;
    Image *image;
    atomic_int next_row;
} Frame;

static void *draw_rows(void *shared)
{
    Frame *frame = shared;
    const EmbreePeer *peer = frame->peer;
    const int width = frame->image->width, height = frame->image->height;
    for (;;) {
        const int first = atomic_fetch_add(&frame->next_row, ROWS_AT_ONCE);
        if (first >= height) {
            return NULL;
        }
        for (int y = first; y < first + ROWS_AT_ONCE && y < height; y++) {
            for (int x = 0; x < width; x++) {
                const Vec3 direction = direction_of(&peer->camera, x, y, width, height);
                const Vec3 color = trace(peer, peer->camera.eye, direction);
                float *pixel =
                    frame->image->pixels + ((size_t)y * (size_t)width + (size_t)x) * IMAGE_CHANNELS;
                pixel[0] = color.x;
                pixel[1] = color.y;
                pixel[2] = color.z;
                pixel[3] = 1;
            }
        }
    }
}

void embree_peer_draw(EmbreePeer *peer, Image *image)
{
    Frame frame = {.peer = peer, .image = image};
    pthread_t threads[MAX_THREADS];
    int n_started = 0;
    // This thread draws, too.
    while (n_started < peer->n_threads - 1 &&
           pthread_create(&threads[n_started], NULL, draw_rows, &frame) == 0) {
        n_started++;
    }
    draw_rows(&frame);
    for (int i = 0; i < n_started; i++) {
        pthread_join(threads[i], NULL);
    }
}

#else

#include <stddef.h>

const char *embree_peer_version(void)
{
    return NULL;
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

void embree_peer_draw(EmbreePeer *peer, Image *image)
{
    (void)peer, (void)image;
}

#endif
