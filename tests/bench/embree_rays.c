// Embree on rays that begin on surfaces (see embree_peer.h): it reads the same rays as the kernel
// of secondary_rays.cl, and writes the same answers.
//
// Neighbours' shadow rays go to one light and are called coherent; mirrored rays are not. Measured
// the other way round there was no difference to be told from chance.
// Read next: secondary_rays.c.
#include "embree_peer.h"

#ifdef WITH_EMBREE

#include "embree_api.h"

#include <stdatomic.h>

// Rays of a call of rtcOccluded1M or rtcIntersect1M, as many as of a primary one; and those that a
// thread takes at once: few, so that the threads end together.
enum { STREAM_RAYS = 64, RAYS_AT_ONCE = 64 * STREAM_RAYS };

// ---- Calls ----------------------------------------------------------------------------------

static inline struct RTCRay query_of(const SecondaryRay *ray)
{
    return (struct RTCRay){.org_x = ray->origin.x,
                           .org_y = ray->origin.y,
                           .org_z = ray->origin.z,
                           .tnear = ray->t_min,
                           .dir_x = ray->direction.x,
                           .dir_y = ray->direction.y,
                           .dir_z = ray->direction.z,
                           .tfar = ray->t_max,
                           .mask = 0xffffffffu};
}

static inline struct RTCRayHit hit_query_of(const SecondaryRay *ray)
{
    return (struct RTCRayHit){
        .ray = query_of(ray),
        .hit = {.primID = NO_SPHERE, .geomID = RTC_INVALID_GEOMETRY_ID},
    };
}

// Embree notes what is blocked by an end before the beginning.
static inline u32 is_blocked(f32 tfar)
{
    return tfar < 0;
}

static void blocked_1(const EmbreePeer *peer, const SecondaryRay *rays, int n_rays, u32 *answers)
{
    (void)n_rays;
    struct RTCRay query = query_of(rays);
    AnyHints hints = any_hints(COHERENT);
    rtcOccluded1(ARGUMENTS(peer, &hints, &query));
    answers[0] = is_blocked(query.tfar);
}

static void nearest_1(const EmbreePeer *peer, const SecondaryRay *rays, int n_rays, u32 *answers)
{
    (void)n_rays;
    struct RTCRayHit query = hit_query_of(rays);
    NearestHints hints = nearest_hints(INCOHERENT);
    rtcIntersect1(ARGUMENTS(peer, &hints, &query));
    answers[0] = query.hit.primID;
}

// The packets: three times three functions that differ in Embree's names alone. The last packet may
// have fewer rays; its other places hold the first one, and are not valid.
#define DEFINE_PACKETS(N)                                                                          \
    static inline void load_##N(const SecondaryRay *rays, int n_rays, int *valid,                  \
                                struct RTCRay##N *query)                                           \
    {                                                                                              \
        for (int i = 0; i < N; i++) {                                                              \
            const SecondaryRay *ray = &rays[i < n_rays ? i : 0];                                   \
            valid[i] = i < n_rays ? -1 : 0;                                                        \
            query->org_x[i] = ray->origin.x;                                                       \
            query->org_y[i] = ray->origin.y;                                                       \
            query->org_z[i] = ray->origin.z;                                                       \
            query->dir_x[i] = ray->direction.x;                                                    \
            query->dir_y[i] = ray->direction.y;                                                    \
            query->dir_z[i] = ray->direction.z;                                                    \
            query->tnear[i] = ray->t_min;                                                          \
            query->tfar[i] = ray->t_max;                                                           \
            query->time[i] = 0;                                                                    \
            query->mask[i] = 0xffffffffu;                                                          \
            query->id[i] = query->flags[i] = 0;                                                    \
        }                                                                                          \
    }                                                                                              \
                                                                                                   \
    static void blocked_##N(const EmbreePeer *peer, const SecondaryRay *rays, int n_rays,          \
                            u32 *answers)                                                          \
    {                                                                                              \
        _Alignas(4 * N) int valid[N];                                                              \
        struct RTCRay##N query;                                                                    \
        load_##N(rays, n_rays, valid, &query);                                                     \
        AnyHints hints = any_hints(COHERENT);                                                      \
        rtcOccluded##N(valid, ARGUMENTS(peer, &hints, &query));                                    \
        for (int i = 0; i < n_rays; i++) {                                                         \
            answers[i] = is_blocked(query.tfar[i]);                                                \
        }                                                                                          \
    }                                                                                              \
                                                                                                   \
    static void nearest_##N(const EmbreePeer *peer, const SecondaryRay *rays, int n_rays,          \
                            u32 *answers)                                                          \
    {                                                                                              \
        _Alignas(4 * N) int valid[N];                                                              \
        struct RTCRayHit##N query;                                                                 \
        load_##N(rays, n_rays, valid, &query.ray);                                                 \
        for (int i = 0; i < N; i++) {                                                              \
            query.hit.primID[i] = NO_SPHERE;                                                       \
            query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;                                         \
        }                                                                                          \
        NearestHints hints = nearest_hints(INCOHERENT);                                            \
        rtcIntersect##N(valid, ARGUMENTS(peer, &hints, &query));                                   \
        for (int i = 0; i < n_rays; i++) {                                                         \
            answers[i] = query.hit.primID[i];                                                      \
        }                                                                                          \
    }
DEFINE_PACKETS(4)
DEFINE_PACKETS(8)
DEFINE_PACKETS(16)

#if WITH_EMBREE == 3
static void blocked_stream(const EmbreePeer *peer, const SecondaryRay *rays, int n_rays,
                           u32 *answers)
{
    struct RTCRay queries[STREAM_RAYS];
    for (int i = 0; i < n_rays; i++) {
        queries[i] = query_of(&rays[i]);
    }
    AnyHints hints = any_hints(COHERENT);
    rtcOccluded1M(ARGUMENTS(peer, &hints, queries), (unsigned)n_rays, sizeof *queries);
    for (int i = 0; i < n_rays; i++) {
        answers[i] = is_blocked(queries[i].tfar);
    }
}

static void nearest_stream(const EmbreePeer *peer, const SecondaryRay *rays, int n_rays,
                           u32 *answers)
{
    struct RTCRayHit queries[STREAM_RAYS];
    for (int i = 0; i < n_rays; i++) {
        queries[i] = hit_query_of(&rays[i]);
    }
    NearestHints hints = nearest_hints(INCOHERENT);
    rtcIntersect1M(ARGUMENTS(peer, &hints, queries), (unsigned)n_rays, sizeof *queries);
    for (int i = 0; i < n_rays; i++) {
        answers[i] = queries[i].hit.primID;
    }
}
#else
// embree_peer_has() says that there is none.
#define blocked_stream NULL
#define nearest_stream NULL
#endif

// Ask for n_rays rays, at most those of a call.
typedef void Ask(const EmbreePeer *peer, const SecondaryRay *rays, int n_rays, u32 *answers);

static const struct CallRow {
    int n_rays;  // of a call
    Ask *asks[N_RAY_KINDS];
} CALLS[N_EMBREE_CALLS] = {
    [EMBREE_1] = {1, {blocked_1, nearest_1}},
    [EMBREE_4] = {4, {blocked_4, nearest_4}},
    [EMBREE_8] = {8, {blocked_8, nearest_8}},
    [EMBREE_16] = {16, {blocked_16, nearest_16}},
    [EMBREE_STREAM] = {STREAM_RAYS, {blocked_stream, nearest_stream}},
};

// ---- All rays -------------------------------------------------------------------------------

// What the threads of one search share.
typedef struct Search {
    const EmbreePeer *peer;
    EmbreeCall call;
    RayKind kind;
    const SecondaryRay *rays;
    int n_rays;
    u32 *answers;
    atomic_int next_ray;
} Search;

static int smaller_of(int a, int b)
{
    return a < b ? a : b;
}

static void *search_rays(void *shared)
{
    Search *search = shared;
    const int n_a_call = CALLS[search->call].n_rays;
    Ask *ask = CALLS[search->call].asks[search->kind];
    for (;;) {
        const int first = atomic_fetch_add(&search->next_ray, RAYS_AT_ONCE);
        if (first >= search->n_rays) {
            return NULL;
        }
        const int end = smaller_of(first + RAYS_AT_ONCE, search->n_rays);
        for (int i = first; i < end; i += n_a_call) {
            ask(search->peer, search->rays + i, smaller_of(n_a_call, end - i), search->answers + i);
        }
    }
}

void embree_peer_search(const EmbreePeer *peer, EmbreeCall call, RayKind kind,
                        const SecondaryRay *rays, int n_rays, u32 *answers)
{
    Search search = {.peer = peer,
                     .call = call,
                     .kind = kind,
                     .rays = rays,
                     .n_rays = n_rays,
                     .answers = answers};
    embree_peer_run(peer, search_rays, &search);
}

#else

void embree_peer_search(const EmbreePeer *peer, EmbreeCall call, RayKind kind,
                        const SecondaryRay *rays, int n_rays, u32 *answers)
{
    (void)peer, (void)call, (void)kind, (void)rays, (void)n_rays, (void)answers;
}

#endif
