// Writing memcheck's jobs (see memcheck_job.h).
#include "memcheck_job.h"

#include "complain.h"
#include "jobs_01.h"
#include "jobs_03.h"
#include "jobs_04.h"
#include "jobs_05.h"
#include "jobs_07.h"
#include "jobs_09.h"
#include "jobs_10.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum {
    MAX_SIDE = 16,       // of a picture of circles, pixels
    MAX_SIDE_3D = 8,     // of one of spheres
    MAX_SCENES = 6,      // spread over the job's
    MAX_SCENES_3D = 3,   // the same
    MAX_CALLS = 32,      // of each function, spread over the job's inputs
    MAX_SPHERES = 8192,  // of a scene of spheres: a naive kernel asks them all, for each pixel
    JOB_SCENES = 64,     // no judge's job has more
};

// Sections with one record a call of a function. Of all others every byte is needed.
static const struct {
    const char *name;
    size_t record_bytes;
} calls[] = {
    {"overlaps", sizeof(OverlapJob)},
    {"children", sizeof(ChildJob)},
    {"views", sizeof(ViewJob)},
    {"pixels", sizeof(PixelJob)},
    {"roots", sizeof(RootJob)},
    {"textbook", sizeof(SphereRayJob)},
    {"projection", sizeof(SphereRayJob)},
    {"normals", sizeof(NormalJob)},
    {"shades", sizeof(ShadeJob)},
    {"clips", sizeof(ClipJob)},
    {"sides", sizeof(SideJob)},
    {"planes", sizeof(PlaneJob)},
    {"leaves", sizeof(SearchJob)},
    {"starts", sizeof(StartJob)},
    {"mirrors", sizeof(MirrorJob)},
    {"shadow_rays", sizeof(ShadowRayJob)},
    {"blocks", sizeof(BlockJob)},
    {"lits", sizeof(LitJob)},
    {"tile_planes", sizeof(TilePlaneJob)},
    {"tile_children", sizeof(TileChildJob)},
    {"tile_waiting", sizeof(TileWaitingJob)},
    {"cones", sizeof(ConeJob)},
    {"circle_rows", sizeof(CircleRowJob)},
    {"tile_leaves", sizeof(CircleTileJob)},
    {"circle_tiles", sizeof(CircleTileJob)},
};
static const char *const whole[] = {
    "children.relations", "children.boxes", "lights",     "leaf_ids",     "leaf_spheres",
    "block_ids",          "block_spheres",  "lit_lights", "circle_nodes", "leaf_circles"};

#define COUNT(array) (sizeof(array) / sizeof *(array))

// ---- The judge's job, array by array ------------------------------------------------------------

// The parts of a scene that have one entry more than the scene.
static const struct {
    const char *part;
    size_t entry_bytes;
} longer[] = {
    {"circles", sizeof(Circle)},     {"map", sizeof(u32)},
    {"spheres", sizeof(Sphere)},     {"material_ids", sizeof(u32)},
    {"materials", sizeof(Material)}, {"lights", sizeof(Light)},
};

// Does a leaf of scene k name the sphere behind the last? That is one of the scene's then.
static int is_decoy_named(const Sections *judges, int k)
{
    char name[SECTION_NAME_BYTES];
    size_t n_bytes = 0;
    snprintf(name, sizeof name, "scene.%d", k);
    const SceneJob3D *scene = sections_find(judges, name, sizeof *scene);
    snprintf(name, sizeof name, "scene.%d.sphere_ids", k);
    const u32 *ids = sections_find_any(judges, name, &n_bytes);
    for (size_t i = 0; scene != NULL && ids != NULL && i < n_bytes / sizeof *ids; i++) {
        if (ids[i] == (u32)scene->n_spheres) {
            return 1;
        }
    }
    return 0;
}

// The bytes behind the end of the array in a section.
static size_t bytes_behind(const Sections *judges, const char *name)
{
    int k, n_read = 0;
    if (sscanf(name, "scene.%9d.%n", &k, &n_read) != 1 || n_read == 0) {
        return 0;
    }
    for (size_t i = 0; i < COUNT(longer); i++) {
        if (strcmp(name + n_read, longer[i].part) == 0 && !is_decoy_named(judges, k)) {
            return longer[i].entry_bytes;
        }
    }
    return 0;
}

static int failed_to_write(void)
{
    complain("memcheck: the job cannot be written");
    return -1;
}

int memcheck_job_write(const Sections *judges, FILE *file)
{
    size_t place = 0, n_bytes;
    const char *name;
    const void *bytes;
    while ((bytes = sections_next(judges, &place, &name, &n_bytes)) != NULL) {
        const size_t less = bytes_behind(judges, name);
        if (n_bytes < less || section_write(file, name, bytes, n_bytes - less) != 0) {
            return failed_to_write();
        }
    }
    return 0;
}

// ---- Functions --------------------------------------------------------------------------------

// Some of a section's records, from its beginning to its end.
static int calls_write(const Sections *job, const char *name, size_t record_bytes, FILE *file)
{
    size_t n_bytes;
    const unsigned char *records = sections_find_any(job, name, &n_bytes);
    unsigned char some[MAX_CALLS * sizeof(CircleRowJob)];  // the largest record
    if (records == NULL) {
        return 0;
    }
    const size_t n = n_bytes / record_bytes, n_some = n < MAX_CALLS ? n : MAX_CALLS;
    for (size_t i = 0; i < n_some; i++) {
        memcpy(some + i * record_bytes, records + i * n / n_some * record_bytes, record_bytes);
    }
    return section_write(file, name, some, n_some * record_bytes);
}

static int functions_write(const Sections *job, FILE *file)
{
    int result = 0;
    for (size_t i = 0; i < COUNT(calls); i++) {
        result |= calls_write(job, calls[i].name, calls[i].record_bytes, file);
    }
    for (size_t i = 0; i < COUNT(whole); i++) {
        size_t n_bytes;
        const void *bytes = sections_find_any(job, whole[i], &n_bytes);
        result |= bytes ? section_write(file, whole[i], bytes, n_bytes) : 0;
    }
    return result;
}

// ---- Scenes -----------------------------------------------------------------------------------

// Scene number k of the judge's job, which is number `as` of the small one.
typedef struct SmallScene {
    const Sections *job;
    int k, as;
    FILE *file;
} SmallScene;

// "scene.K" or "scene.K.part".
static void scene_name(char name[SECTION_NAME_BYTES], int k, const char *part)
{
    const unsigned number = (unsigned)k % JOB_SCENES;
    if (part != NULL) {
        snprintf(name, SECTION_NAME_BYTES, "scene.%u.%s", number, part);
    } else {
        snprintf(name, SECTION_NAME_BYTES, "scene.%u", number);
    }
}

static const void *scene_part(const SmallScene *scene, const char *part, size_t *n_bytes)
{
    char name[SECTION_NAME_BYTES];
    scene_name(name, scene->k, part);
    return sections_find_any(scene->job, name, n_bytes);
}

static int scene_write(const SmallScene *scene, const char *part, const void *bytes, size_t n_bytes)
{
    char name[SECTION_NAME_BYTES];
    scene_name(name, scene->as, part);
    return section_write(scene->file, name, bytes, n_bytes);
}

// Write those parts that there are as they are.
static int parts_write(const SmallScene *scene, const char *const parts[], size_t n)
{
    int result = 0;
    for (size_t i = 0; i < n; i++) {
        size_t n_bytes;
        const void *bytes = scene_part(scene, parts[i], &n_bytes);
        result |= bytes != NULL ? scene_write(scene, parts[i], bytes, n_bytes) : 0;
    }
    return result;
}

// The power of two that makes a picture small: in 2D it scales circles and cells without rounding.
static float scale_of(int width, int height, float max_side)
{
    float scale = 1;
    while ((float)width * scale > max_side || (float)height * scale > max_side) {
        scale /= 2;
    }
    return scale;
}

static int scaled_side(int side, float scale)
{
    const int scaled = (int)((float)side * scale);
    return scaled > 1 ? scaled : 1;
}

// Write a part whose records are floats, the first n_scaled of n of each scaled.
static int scaled_write(const SmallScene *scene, const char *part, size_t n_scaled, size_t n,
                        float scale)
{
    size_t n_bytes;
    const float *given = scene_part(scene, part, &n_bytes);
    float *scaled = given != NULL ? malloc(n_bytes + 1) : NULL;
    if (scaled == NULL) {
        return given != NULL ? -1 : 0;  // lab 00 has no circles
    }
    for (size_t i = 0; i < n_bytes / sizeof *scaled; i++) {
        scaled[i] = given[i] * (i % n < n_scaled ? scale : 1);
    }
    const int result = scene_write(scene, part, scaled, n_bytes);
    free(scaled);
    return result;
}

static int scene2d_write(const SmallScene *scene, SceneJob header)
{
    static const char *const parts[] = {"pattern", "relations", "flags", "map"};
    enum { N_CIRCLE = sizeof(Circle) / sizeof(f32), N_BOX = sizeof(BBox2D) / sizeof(f32) };
    const size_t n_place = offsetof(Circle, depth) / sizeof(f32);  // x, y and the radius
    const float scale = scale_of(header.width, header.height, MAX_SIDE);
    header.width = scaled_side(header.width, scale);
    header.height = scaled_side(header.height, scale);
    return scene_write(scene, NULL, &header, sizeof header) |
           scaled_write(scene, "circles", n_place, N_CIRCLE, scale) |
           scaled_write(scene, "boxes", N_BOX, N_BOX, scale) |
           parts_write(scene, parts, COUNT(parts));
}

// The display's size is the camera's: fewer pixels show all of it.
static int scene3d_write(const SmallScene *scene, SceneJob3D header)
{
    static const char *const parts[] = {"spheres", "material_ids", "materials", "lights",
                                        "bounces", "leaf_spheres", "nodes",     "sphere_ids"};
    const float scale = scale_of(header.width, header.height, MAX_SIDE_3D);
    header.width = scaled_side(header.width, scale);
    header.height = scaled_side(header.height, scale);
    return scene_write(scene, NULL, &header, sizeof header) |
           parts_write(scene, parts, COUNT(parts));
}

static int is_too_large(const SmallScene *scene)
{
    size_t n_bytes = 0;
    return scene_part(scene, "spheres", &n_bytes) != NULL && n_bytes / sizeof(Sphere) > MAX_SPHERES;
}

static int scenes_write(const Sections *job, FILE *file)
{
    SmallScene scene = {.job = job, .file = file};
    size_t n_bytes = 0, header_bytes;
    for (; scene.k < JOB_SCENES && scene_part(&scene, NULL, &header_bytes) != NULL; scene.k++) {
        n_bytes = header_bytes;
    }
    const int is_2d = n_bytes == sizeof(SceneJob), n = scene.k;
    const int n_most = is_2d ? MAX_SCENES : MAX_SCENES_3D, n_small = n < n_most ? n : n_most;
    int result = 0;
    for (scene.as = 0; scene.as < n_small; scene.as++) {
        scene.k = scene.as * n / n_small;
        if (scene.k + 1 < n && is_too_large(&scene)) {
            scene.k++;
        }
        const void *header = scene_part(&scene, NULL, &header_bytes);
        result |= is_2d ? scene2d_write(&scene, *(const SceneJob *)header)
                        : scene3d_write(&scene, *(const SceneJob3D *)header);
    }
    return result;
}

int memcheck_job_write_small(const Sections *job, FILE *file)
{
    return functions_write(job, file) | scenes_write(job, file) ? failed_to_write() : 0;
}
