// grader/judge_NN: each lab's checks and job, right answers, and answers that are missing, of a
// wrong size or garbage.
//
// The right answers are worked out here, in plain C; that they pass shows that what is done to them
// afterwards is what fails.
#include "camera_from_view.h"
#include "job_scene.h"
#include "jobs.h"
#include "judge.h"
#include "manifest.h"
#include "oracle2d.h"
#include "random.h"
#include "surroundings.h"
#include "work.h"

#include <criterion/parameterized.h>
#include <glob.h>
#include <math.h>

TestSuite(judges, .timeout = 60);

static const char *const lab_names[] = {"00-hello-pixels",    "01-naive-2d",
                                        "02-kdtree-2d-build", "03-kdtree-2d-render",
                                        "04-camera-rays",     "05-spheres"};
enum { N_LABS = sizeof lab_names / sizeof *lab_names };

// Each test runs once a lab.
#define LAB_TEST(name)                                                                             \
    ParameterizedTestParameters(judges, name)                                                      \
    {                                                                                              \
        static int numbers[N_LABS];                                                                \
        for (int i = 0; i < N_LABS; i++) {                                                         \
            numbers[i] = i;                                                                        \
        }                                                                                          \
        return cr_make_param_array(int, numbers, N_LABS);                                          \
    }                                                                                              \
    ParameterizedTest(const int *lab, judges, name)

// ---- Section files in memory --------------------------------------------------------------------

typedef struct Writer {
    FILE *file;
    char *bytes;
    size_t n_bytes;
} Writer;

static void writer_open(Writer *writer)
{
    *writer = (Writer){0};
    writer->file = open_memstream(&writer->bytes, &writer->n_bytes);
    cr_assert_not_null(writer->file);
}

static Sections writer_close(Writer *writer)
{
    fclose(writer->file);
    return (Sections){(unsigned char *)writer->bytes, writer->n_bytes};
}

static void answer(Writer *writer, const char *name, const void *bytes, size_t n_bytes)
{
    cr_assert_eq(section_write(writer->file, name, bytes, n_bytes), 0);
}

// Section "name.k" or "name.k.part".
static const char *numbered(const char *name, int k, const char *part)
{
    static char text[2 * SECTION_NAME_BYTES];
    snprintf(text, sizeof text, "%s.%d%s%s", name, k, part ? "." : "", part ? part : "");
    return text;
}

// One section of a file, as sections.h lays it out.
typedef struct Section {
    char name[SECTION_NAME_BYTES];
    const unsigned char *bytes;
    size_t n_bytes;
} Section;

enum { MAX_SECTIONS = 64 };

static int list_sections(const Sections *sections, Section list[MAX_SECTIONS])
{
    int n = 0;
    for (size_t at = 0; at < sections->n_bytes; n++) {
        cr_assert_lt(n, MAX_SECTIONS);
        uint64_t n_bytes;
        memcpy(list[n].name, sections->bytes + at, SECTION_NAME_BYTES);
        memcpy(&n_bytes, sections->bytes + at + SECTION_NAME_BYTES, sizeof n_bytes);
        list[n].bytes = sections->bytes + at + SECTION_NAME_BYTES + sizeof n_bytes;
        list[n].n_bytes = (size_t)n_bytes;
        at += SECTION_NAME_BYTES + sizeof n_bytes +
              (list[n].n_bytes + SECTION_ALIGNMENT - 1) / SECTION_ALIGNMENT * SECTION_ALIGNMENT;
    }
    return n;
}

// ---- Right answers ------------------------------------------------------------------------------

// A job, as the judge keeps it and as the probe reads it.
typedef struct Open {
    const Judge *judge;
    void *job;
    Sections file;
} Open;

static Open job_open(int lab, uint64_t seed)
{
    Open open = {.judge = judge_of(lab_names[lab])};
    cr_assert_not_null(open.judge, "%s", lab_names[lab]);
    Writer writer;
    writer_open(&writer);
    open.job = open.judge->job_new(seed, writer.file);
    open.file = writer_close(&writer);
    cr_assert_not_null(open.job);
    return open;
}

static void job_close(Open *open)
{
    open->judge->job_free(open->job);
    sections_free(&open->file);
}

// A scene as the probe gets it: nothing in it is copied.
static int scene_read(const Sections *job, int k, JobScene *scene)
{
    size_t n_bytes;
    const SceneJob *header = sections_find(job, numbered("scene", k, NULL), sizeof *header);
    if (header == NULL) {
        return 0;
    }
    *scene = (JobScene){.limits = {header->maxDepth, header->targetElementsPerNode}};
    scene->scene =
        (Scene2D){(Circle *)sections_find_any(job, numbered("scene", k, "circles"), &n_bytes),
                  header->n_circles, header->width, header->height};
    KdTree2D *tree = &scene->tree;
    tree->nodes_Relations =
        (NodeRel *)sections_find_any(job, numbered("scene", k, "relations"), &n_bytes);
    tree->nodes_flag = (u8 *)sections_find_any(job, numbered("scene", k, "flags"), &n_bytes);
    tree->nodes_BBox = (BBox2D *)sections_find_any(job, numbered("scene", k, "boxes"), &n_bytes);
    tree->mapNode2Circles = (u32 *)sections_find_any(job, numbered("scene", k, "map"), &n_bytes);
    return 1;
}

static u32 containing_child(const KdTree2D *tree, u32 id, float x, float y)
{
    const NodeRel node = tree->nodes_Relations[id];
    const BBox2D left = tree->nodes_BBox[node.lChild];
    return x >= left.minX && x < left.maxX && y >= left.minY && y < left.maxY ? node.lChild
                                                                              : node.rChild;
}

// A pixel's colour through the tree, or past all circles where there is none, and what it cost.
static Work draw_pixel(const JobScene *scene, int x, int y, float color[IMAGE_CHANNELS])
{
    const KdTree2D *tree = &scene->tree;
    Work work = {0};
    const u32 *ids = NULL;
    u32 n_ids = (u32)scene->scene.n_circles;
    if (tree->nodes_Relations != NULL) {
        u32 id = 0;
        for (; tree->nodes_flag[id] != LEAF; work.n_nodes_visited++) {
            id = containing_child(tree, id, (float)x, (float)y);
        }
        ids = tree->mapNode2Circles + tree->nodes_Relations[id].circleMapOffset;
        n_ids = *ids++;
    }
    float min_depth = INFINITY;
    memset(color, 0, IMAGE_CHANNELS * sizeof *color);
    for (u32 i = 0; i < n_ids; i++, work.n_tests++) {
        const Circle c = scene->scene.circles[ids ? ids[i] : i];
        const float dx = (float)x - c.x, dy = (float)y - c.y;
        if (dx * dx + dy * dy <= c.radius * c.radius && c.depth < min_depth) {
            min_depth = c.depth;
            memcpy(color, (float[]){c.r, c.g, c.b, c.a}, IMAGE_CHANNELS * sizeof *color);
        }
    }
    return work;
}

// The pictures of all scenes; of lab 00 the gradient, twice, of lab 03 the work for scene 1
// besides.
static void answer_pictures(Writer *writer, int lab, const Sections *job)
{
    JobScene scene;
    for (int k = 0; scene_read(job, k, &scene); k++) {
        const int width = scene.scene.width, height = scene.scene.height;
        const int image_width = PROBE_IMAGE_SIDE(width);
        const size_t n_pixels = (size_t)image_width * PROBE_IMAGE_SIDE((size_t)height);
        float(*image)[IMAGE_CHANNELS] = malloc(n_pixels * sizeof *image);
        float(*inside)[IMAGE_CHANNELS] = malloc((size_t)(width * height) * sizeof *inside);
        Work *work = calloc(n_pixels, sizeof *work);
        for (size_t i = 0; i < n_pixels * IMAGE_CHANNELS; i++) {
            image[i / IMAGE_CHANNELS][i % IMAGE_CHANNELS] = UNWRITTEN;
        }
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                float *pixel = image[y * image_width + x];
                if (lab == 0) {
                    memcpy(pixel,
                           (float[]){(float)x / (float)width, (float)y / (float)height, 0.25f, 1},
                           sizeof *image);
                } else {
                    work[y * width + x] = draw_pixel(&scene, x, y, pixel);
                }
                memcpy(inside[y * width + x], pixel, sizeof *image);
            }
        }
        answer(writer, numbered("picture", k, NULL), image, n_pixels * sizeof *image);
        if (lab == 0) {
            answer(writer, numbered("readback", k, NULL), inside,
                   (size_t)(width * height) * sizeof *inside);
        }
        // The two scenes whose work is judged: a wide one, and one whose root is a leaf.
        if (lab == 3 && (k == 1 || k == 10)) {
            answer(writer, numbered("work", k, NULL), work, n_pixels * sizeof *work);
        }
        free(work);
        free(inside);
        free(image);
    }
}

static void answer_overlaps(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const OverlapJob *inputs = sections_find_any(job, "overlaps", &n_bytes);
    const size_t n = n_bytes / sizeof *inputs;
    i32 *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        const Circle c = inputs[i].circle;
        const float dx = (float)inputs[i].x - c.x, dy = (float)inputs[i].y - c.y;
        answers[i] = dx * dx + dy * dy <= c.radius * c.radius && c.depth < inputs[i].minDepth;
    }
    answer(writer, "overlaps", answers, n * sizeof *answers);
    free(answers);
}

static void answer_leaves_and_boxes(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const LeafJob *leaves = sections_find_any(job, "leaves", &n_bytes);
    size_t n = n_bytes / sizeof *leaves;
    i32 *decisions = calloc(n, sizeof *decisions);
    for (size_t i = 0; i < n; i++) {
        decisions[i] = is_leaf(leaves[i].level, leaves[i].n_circles,
                               (KdTreeLimits){leaves[i].maxDepth, leaves[i].targetElementsPerNode});
    }
    answer(writer, "leaves", decisions, n * sizeof *decisions);
    free(decisions);

    const BBox2D *boxes = sections_find_any(job, "splits", &n_bytes);
    n = n_bytes / sizeof *boxes;
    BBox2D(*halves)[2] = calloc(n, sizeof *halves);
    for (size_t i = 0; i < n; i++) {
        split_box(boxes[i], &halves[i][0], &halves[i][1]);
    }
    answer(writer, "splits", halves, n * sizeof *halves);
    free(halves);

    const BoxOverlapJob *pairs = sections_find_any(job, "overlaps", &n_bytes);
    n = n_bytes / sizeof *pairs;
    decisions = calloc(n, sizeof *decisions);
    for (size_t i = 0; i < n; i++) {
        decisions[i] = circle_overlaps_box(pairs[i].circle, pairs[i].box);
    }
    answer(writer, "overlaps", decisions, n * sizeof *decisions);
    free(decisions);
}

static void answer_lists(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    JobScene scene;
    cr_assert(scene_read(job, 0, &scene));
    const DistributeJob *nodes = sections_find_any(job, "distribute", &n_bytes);
    size_t n = n_bytes / sizeof *nodes;
    u32(*lists)[DISTRIBUTE_ROOM] = calloc(n, sizeof *lists);
    for (size_t i = 0; i < n; i++) {
        for (int j = 0; j < DISTRIBUTE_ROOM; j++) {
            lists[i][j] = UNTOUCHED;
        }
        lists[i][0] = distribute(scene.scene.circles, nodes[i].ids, nodes[i].n_ids, nodes[i].child,
                                 lists[i] + 1);
    }
    answer(writer, "distribute", lists, n * sizeof *lists);
    free(lists);

    const PackJob *leaves = sections_find_any(job, "pack", &n_bytes);
    n = n_bytes / sizeof *leaves;
    PackAnswer *packed = calloc(n, sizeof *packed);
    for (size_t i = 0; i < n; i++) {
        u8 flags[PACK_NODES];
        for (u32 id = 0; id < PACK_NODES; id++) {
            packed[i].relations[id].id = id;
            flags[id] = INNER;
        }
        for (int j = 0; j < PACK_MAP_ROOM; j++) {
            packed[i].map[j] = UNTOUCHED;
        }
        KdTree2D tree = {packed[i].relations, flags,      NULL,
                         packed[i].map,       PACK_NODES, leaves[i].n_map};
        pack_leaf(&tree, leaves[i].id, leaves[i].ids, leaves[i].n_ids);
        packed[i].n_map = tree.n_map;
        for (u32 id = 0; id < PACK_NODES; id++) {
            packed[i].flags[id] = flags[id];
        }
    }
    answer(writer, "pack", packed, n * sizeof *packed);
    free(packed);
}

static void answer_trees(Writer *writer, const Sections *job)
{
    JobScene scene;
    for (int k = 0; scene_read(job, k, &scene); k++) {
        KdTree2D tree;
        cr_assert_eq(
            kdtree2d_build(scene.scene.circles, (u32)scene.scene.n_circles, scene.limits, &tree),
            0);
        const TreeAnswer header = {tree.n_nodes, tree.n_map};
        answer(writer, numbered("tree", k, NULL), &header, sizeof header);
        answer(writer, numbered("tree", k, "relations"), tree.nodes_Relations,
               tree.n_nodes * sizeof *tree.nodes_Relations);
        answer(writer, numbered("tree", k, "flags"), tree.nodes_flag, tree.n_nodes);
        answer(writer, numbered("tree", k, "boxes"), tree.nodes_BBox,
               tree.n_nodes * sizeof *tree.nodes_BBox);
        answer(writer, numbered("tree", k, "map"), tree.mapNode2Circles, tree.n_map * sizeof(u32));
        tree2d_free(&tree);
    }
}

static void answer_children(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    JobScene scene;
    cr_assert(scene_read(job, 0, &scene));
    const ChildJob *inputs = sections_find_any(job, "children", &n_bytes);
    const size_t n = n_bytes / sizeof *inputs;
    u32 *children = calloc(n, sizeof *children);
    for (size_t i = 0; i < n; i++) {
        children[i] =
            containing_child(&scene.tree, inputs[i].id, (float)inputs[i].x, (float)inputs[i].y);
    }
    answer(writer, "children", children, n * sizeof *children);
    free(children);
}

// ---- 3D

// The ray of a pixel; its t_min is 0.
typedef struct Ray {
    Vec3 origin, direction;
} Ray;

static Vec3 vec3_plus(Vec3 a, Vec3 b)
{
    return (Vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static Vec3 on_display(int x, int y, int width, int height, float fov)
{
    const float size = fov / (float)width;
    return (Vec3){((float)x + 0.5f - 0.5f * (float)width) * size,
                  (0.5f * (float)height - (float)y - 0.5f) * size, 1};
}

static Ray primary_ray(int x, int y, int width, int height, const Camera *camera)
{
    const Vec3 p = on_display(x, y, width, height, camera->fov);
    const Vec3 in_plane = vec3_plus(vec3_scaled(camera->right, p.x), vec3_scaled(camera->up, p.y));
    return (Ray){camera->eye, vec3_normalized(vec3_plus(in_plane, camera->forward))};
}

static void answer_axes_and_pixels(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const ViewJob *views = sections_find_any(job, "views", &n_bytes);
    size_t n = n_bytes / sizeof *views;
    Vec3(*axes)[3] = calloc(n, sizeof *axes);
    for (size_t i = 0; i < n; i++) {
        const View view = {.from = views[i].from, .at = views[i].at, .up = views[i].up};
        camera_axes(view, &axes[i][0], &axes[i][1], &axes[i][2]);
    }
    answer(writer, "axes", axes, n * sizeof *axes);
    free(axes);

    const PixelJob *pixels = sections_find_any(job, "pixels", &n_bytes);
    n = n_bytes / sizeof *pixels;
    PixelAnswer *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        const PixelJob p = pixels[i];
        const Ray ray = primary_ray(p.x, p.y, p.width, p.height, &p.camera);
        answers[i] = (PixelAnswer){on_display(p.x, p.y, p.width, p.height, p.camera.fov),
                                   ray.origin, ray.direction, 0, INFINITY};
    }
    answer(writer, "pixels", answers, n * sizeof *answers);
    free(answers);
}

static float nearest_root(float b, float disc, float radius, float t_min)
{
    if (disc < 0) {
        return INFINITY;
    }
    const float enter = b - sqrtf(disc), leave = b + sqrtf(disc);
    return enter > t_min && radius > 0 ? enter : leave > t_min ? leave : INFINITY;
}

static float intersect(Sphere sphere, Ray ray, float t_min)
{
    const Vec3 c = vec3_minus((Vec3){sphere.x, sphere.y, sphere.z}, ray.origin);
    const float b = vec3_dot(c, ray.direction);
    const Vec3 l = vec3_minus(c, vec3_scaled(ray.direction, b));
    return nearest_root(b, sphere.radius * sphere.radius - vec3_dot(l, l), sphere.radius, t_min);
}

static Vec3 surface_normal(Sphere sphere, Vec3 point, Vec3 direction)
{
    const Vec3 centre = {sphere.x, sphere.y, sphere.z};
    const Vec3 normal = vec3_normalized(vec3_minus(point, centre));
    return vec3_scaled(normal, vec3_dot(normal, direction) > 0 ? -1 : 1);
}

static Vec3 shade(Vec3 point, Vec3 normal, Material material, const Light *lights, int n_lights)
{
    Vec3 color = {0};
    for (int i = 0; i < n_lights; i++) {
        const Vec3 to_light = vec3_normalized(vec3_minus(lights[i].position, point));
        const float share = material.kd * fmaxf(0, vec3_dot(normal, to_light));
        color.x += share * material.color.x * lights[i].color.x;
        color.y += share * material.color.y * lights[i].color.y;
        color.z += share * material.color.z * lights[i].color.z;
    }
    return color;
}

static void answer_spheres(Writer *writer, const Sections *job, const char *name)
{
    size_t n_bytes;
    const SphereRayJob *inputs = sections_find_any(job, name, &n_bytes);
    const size_t n = n_bytes / sizeof *inputs;
    float *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        const Ray ray = {inputs[i].origin, inputs[i].direction};
        answers[i] = intersect(inputs[i].sphere, ray, inputs[i].t_min);
    }
    answer(writer, name, answers, n * sizeof *answers);
    free(answers);
}

static void answer_sphere_functions(Writer *writer, const Sections *job)
{
    size_t n_bytes, n_light_bytes;
    const RootJob *roots = sections_find_any(job, "roots", &n_bytes);
    size_t n = n_bytes / sizeof *roots;
    float *distances = calloc(n, sizeof *distances);
    for (size_t i = 0; i < n; i++) {
        distances[i] = nearest_root(roots[i].b, roots[i].disc, roots[i].radius, roots[i].t_min);
    }
    answer(writer, "roots", distances, n * sizeof *distances);
    free(distances);
    answer_spheres(writer, job, "textbook");
    answer_spheres(writer, job, "projection");

    const NormalJob *points = sections_find_any(job, "normals", &n_bytes);
    n = n_bytes / sizeof *points;
    Vec3 *vectors = calloc(n, sizeof *vectors);
    for (size_t i = 0; i < n; i++) {
        vectors[i] = surface_normal(points[i].sphere, points[i].point, points[i].direction);
    }
    answer(writer, "normals", vectors, n * sizeof *vectors);
    free(vectors);

    const Light *lights = sections_find_any(job, "lights", &n_light_bytes);
    const ShadeJob *shades = sections_find_any(job, "shades", &n_bytes);
    n = n_bytes / sizeof *shades;
    vectors = calloc(n, sizeof *vectors);
    for (size_t i = 0; i < n; i++) {
        const ShadeJob in = shades[i];
        vectors[i] = shade(in.point, in.normal, in.material, lights + in.first_light, in.n_lights);
    }
    answer(writer, "shades", vectors, n * sizeof *vectors);
    free(vectors);
}

// What a ray of scene k hits, and in which colour.
static HitAnswer trace(const Sections *job, int k, const SceneJob3D *scene, Ray ray, Vec3 *color)
{
    size_t n_bytes;
    const Sphere *spheres = sections_find_any(job, numbered("scene", k, "spheres"), &n_bytes);
    const u32 *ids = sections_find_any(job, numbered("scene", k, "material_ids"), &n_bytes);
    const Material *materials = sections_find_any(job, numbered("scene", k, "materials"), &n_bytes);
    const Light *lights = sections_find_any(job, numbered("scene", k, "lights"), &n_bytes);
    HitAnswer hit = {INFINITY, 0xffffffff};
    for (int i = 0; i < scene->n_spheres; i++) {
        const float t = intersect(spheres[i], ray, 0);
        if (t < hit.t) {
            hit = (HitAnswer){t, (u32)i};
        }
    }
    *color = scene->background;
    if (hit.t < INFINITY) {
        const Vec3 point = vec3_plus(ray.origin, vec3_scaled(ray.direction, hit.t));
        const Vec3 normal = surface_normal(spheres[hit.sphere], point, ray.direction);
        *color = shade(point, normal, materials[ids[hit.sphere]], lights, scene->n_lights);
    }
    return hit;
}

// The pictures of all 3D scenes: of lab 04 the directions; of lab 05 the spheres, what each ray
// hits and the work for scene 1 besides.
static void answer_pictures_3d(Writer *writer, int lab, const Sections *job)
{
    const SceneJob3D *scene;
    for (int k = 0; (scene = sections_find(job, numbered("scene", k, NULL), sizeof *scene)); k++) {
        const int width = scene->width, height = scene->height;
        const int image_width = PROBE_IMAGE_SIDE(width);
        const size_t n_pixels = (size_t)image_width * PROBE_IMAGE_SIDE((size_t)height);
        float(*image)[IMAGE_CHANNELS] = malloc(n_pixels * sizeof *image);
        HitAnswer *hits = calloc(n_pixels, sizeof *hits);
        Work *work = calloc(n_pixels, sizeof *work);
        for (size_t i = 0; i < n_pixels * IMAGE_CHANNELS; i++) {
            image[i / IMAGE_CHANNELS][i % IMAGE_CHANNELS] = UNWRITTEN;
        }
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                const Ray ray = primary_ray(x, y, width, height, &scene->camera);
                const Vec3 grey = {0.5f, 0.5f, 0.5f};
                Vec3 color = vec3_plus(vec3_scaled(ray.direction, 0.5f), grey);
                if (lab == 5) {
                    hits[y * width + x] = trace(job, k, scene, ray, &color);
                    work[y * width + x].n_tests = (u32)scene->n_spheres;
                }
                memcpy(image[y * image_width + x], (float[]){color.x, color.y, color.z, 1},
                       sizeof *image);
            }
        }
        answer(writer, numbered("picture", k, NULL), image, n_pixels * sizeof *image);
        if (lab == 5) {
            answer(writer, numbered("hits", k, NULL), hits,
                   (size_t)(width * height) * sizeof *hits);
        }
        if (lab == 5 && k == 1) {
            answer(writer, numbered("work", k, NULL), work, n_pixels * sizeof *work);
        }
        free(work);
        free(hits);
        free(image);
    }
}

static Sections right_answers(int lab, const Sections *job)
{
    Writer writer;
    writer_open(&writer);
    if (lab == 1) {
        answer_overlaps(&writer, job);
    }
    if (lab == 3) {
        answer_children(&writer, job);
    }
    if (lab == 4) {
        answer_axes_and_pixels(&writer, job);
    }
    if (lab == 5) {
        answer_sphere_functions(&writer, job);
    }
    if (lab == 2) {
        answer_leaves_and_boxes(&writer, job);
        answer_lists(&writer, job);
        answer_trees(&writer, job);
    } else if (lab >= 4) {
        answer_pictures_3d(&writer, lab, job);
    } else {
        answer_pictures(&writer, lab, job);
    }
    return writer_close(&writer);
}

// ---- The tables ---------------------------------------------------------------------------------

Test(judges, every_lab_has_one)
{
    glob_t folders;
    cr_assert_eq(glob("solutions/*", GLOB_ONLYDIR, NULL, &folders), 0, "start in the top folder");
    cr_expect_geq(folders.gl_pathc, N_LABS);
    for (size_t i = 0; i < folders.gl_pathc; i++) {
        const char *lab = strchr(folders.gl_pathv[i], '/') + 1;
        const Judge *judge = judge_of(lab);
        cr_expect(judge != NULL && strcmp(judge->lab, lab) == 0, "%s", lab);
    }
    globfree(&folders);
    cr_expect_null(judge_of("00-hello"));
    cr_expect_null(judge_of(""));
}

LAB_TEST(checks_add_up)
{
    Manifest manifest;
    cr_assert_eq(manifest_load("solutions", lab_names[*lab], &manifest), 0);
    const Judge *judge = judge_of(lab_names[*lab]);
    int sum = 0, task_sums[MANIFEST_MAX_TASKS] = {0};
    cr_assert_leq(judge->n_checks, RESULT_MAX_CHECKS);
    for (int i = 0; i < judge->n_checks; i++) {
        const Check *check = &judge->checks[i];
        cr_assert(check->id != NULL && check->title != NULL, "check %d", i);
        const Task *task = manifest_task(&manifest, check->task);
        cr_assert_not_null(task, "%s: no task called %s", check->id, check->task);
        cr_expect_gt(check->points, 0, "%s", check->id);
        sum += check->points;
        task_sums[task - manifest.tasks] += check->points;
        for (int j = 0; j < i; j++) {
            cr_expect_str_neq(check->id, judge->checks[j].id);
        }
    }
    cr_expect_eq(sum, 100);
    for (int i = 0; i < manifest.n_tasks; i++) {
        cr_expect_eq(task_sums[i], manifest.tasks[i].points, "%s", manifest.tasks[i].id);
    }
    manifest_free(&manifest);
}

LAB_TEST(a_seed_says_all_about_a_job)
{
    Open first = job_open(*lab, 7), same = job_open(*lab, 7), other = job_open(*lab, 8);
    cr_expect_eq(first.file.n_bytes, same.file.n_bytes);
    cr_expect_eq(memcmp(first.file.bytes, same.file.bytes, first.file.n_bytes), 0);
    cr_expect(other.file.n_bytes != first.file.n_bytes ||
              memcmp(first.file.bytes, other.file.bytes, first.file.n_bytes) != 0);
    job_close(&first);
    job_close(&same);
    job_close(&other);
}

LAB_TEST(a_job_that_cannot_be_written_is_none)
{
    FILE *full = fopen("/dev/full", "wb");
    cr_assert_not_null(full);
    cr_expect_null(judge_of(lab_names[*lab])->job_new(7, full));
    fclose(full);
}

// ---- Verdicts -----------------------------------------------------------------------------------

// A check's verdict without its message; a message comes with a failure and only then.
static VerdictKind verdict_on(const Open *open, int check, const Sections *answers)
{
    const Verdict verdict = open->judge->judge(open->job, check, answers);
    cr_expect_eq(verdict.message != NULL, verdict.kind == VERDICT_FAILED, "%s",
                 open->judge->checks[check].id);
    cr_expect(verdict.message == NULL || strlen(verdict.message) > 10);
    free(verdict.message);
    return verdict.kind;
}

// The report's pictures are made from the same answers.
static void add_pictures(const Open *open, const Sections *answers)
{
    Result *result = calloc(1, sizeof *result);
    open->judge->add_pictures(open->job, answers, result);
    cr_expect(result->n_pictures > 0 && result->n_pictures <= RESULT_MAX_PICTURES);
    result_free(result);
    free(result);
}

LAB_TEST(right_answers_pass)
{
    for (uint64_t seed = 1; seed <= 3; seed++) {
        Open open = job_open(*lab, seed);
        Sections answers = right_answers(*lab, &open.file);
        for (int adopted = 0; adopted <= 1; adopted++) {
            for (int i = 0; i < open.judge->n_checks; i++) {
                const Verdict verdict = open.judge->judge(open.job, i, &answers);
                cr_expect_eq(verdict.kind, VERDICT_PASSED, "%s: %s", open.judge->checks[i].id,
                             verdict.message ? verdict.message : "missing");
                free(verdict.message);
            }
            add_pictures(&open, &answers);
            open.judge->adopt(open.job, &answers);
        }
        sections_free(&answers);
        job_close(&open);
    }
}

LAB_TEST(without_answers_nothing_is_judged)
{
    Open open = job_open(*lab, 1);
    Sections nothing = {0}, job = open.file;
    for (int i = 0; i < open.judge->n_checks; i++) {
        cr_expect_eq(verdict_on(&open, i, &nothing), VERDICT_MISSING);
        cr_expect_eq(verdict_on(&open, i, &job), VERDICT_MISSING, "the job is no answer to itself");
    }
    add_pictures(&open, &nothing);
    job_close(&open);
}

// ---- Answers that are not whole -----------------------------------------------------------------

typedef enum Damage { DROPPED, EMPTY, TRUNCATED, OVERSIZED, TWICE, N_DAMAGES } Damage;

// The answers with one section damaged.
static Sections damaged(const Section list[], int n, int victim, Damage damage)
{
    Writer writer;
    writer_open(&writer);
    for (int i = 0; i < n; i++) {
        const Section *s = &list[i];
        if (i != victim || damage == TWICE) {
            answer(&writer, s->name, s->bytes, s->n_bytes);
        }
        if (i == victim && damage != DROPPED) {
            unsigned char *bytes = calloc(s->n_bytes + 1, 1);
            memcpy(bytes, s->bytes, s->n_bytes);
            answer(&writer, s->name, bytes,
                   damage == EMPTY       ? 0
                   : damage == TRUNCATED ? s->n_bytes - 1
                                         : s->n_bytes + (damage == OVERSIZED));
            free(bytes);
        }
    }
    return writer_close(&writer);
}

LAB_TEST(a_section_of_a_wrong_size_is_missing)
{
    Open open = job_open(*lab, 2);
    Sections answers = right_answers(*lab, &open.file);
    Section list[MAX_SECTIONS];
    const int n = list_sections(&answers, list);
    for (int victim = 0; victim < n; victim++) {
        // Work that nobody counted beside a picture is the student's doing, not the probe's end.
        const VerdictKind expected =
            strncmp(list[victim].name, "work.", 5) == 0 ? VERDICT_FAILED : VERDICT_MISSING;
        for (Damage damage = DROPPED; damage < N_DAMAGES; damage++) {
            Sections bad = damaged(list, n, victim, damage);
            int n_hit = 0;
            for (int i = 0; i < open.judge->n_checks; i++) {
                const VerdictKind kind = verdict_on(&open, i, &bad);
                cr_expect(kind == VERDICT_PASSED || kind == expected, "%s, damage %d: %s",
                          list[victim].name, damage, open.judge->checks[i].id);
                n_hit += kind == expected;
            }
            cr_expect_gt(n_hit, 0, "%s, damage %d: nobody noticed", list[victim].name, damage);
            if (damage == DROPPED || damage == OVERSIZED) {
                add_pictures(&open, &bad);
            }
            sections_free(&bad);
        }
    }
    sections_free(&answers);
    job_close(&open);
}

// ---- Garbage ------------------------------------------------------------------------------------

enum { RANDOM_BYTES, RANDOM_FLOATS, RANDOM_SMALL, ZEROS, ONES, NANS, INFINITIES, NOBODY, N_KINDS };

static void fill_with_garbage(int kind, Random *random, unsigned char *bytes, size_t n_bytes)
{
    static const float floats[] = {[NANS] = NAN, [INFINITIES] = INFINITY, [NOBODY] = UNWRITTEN};
    for (size_t i = 0; i < n_bytes; i += 4) {
        uint32_t word = (uint32_t)random_bits(random);
        const float number = kind == RANDOM_FLOATS ? (float)(word % 1000) / 1000 : floats[kind];
        if (kind == RANDOM_SMALL) {
            word %= 40;
        } else if (kind == ZEROS || kind == ONES) {
            word = kind == ONES ? 0xffffffff : 0;
        } else if (kind != RANDOM_BYTES) {
            memcpy(&word, &number, sizeof word);
        }
        memcpy(bytes + i, &word, n_bytes - i < 4 ? n_bytes - i : 4);
    }
}

// Does a tree's header stay, so that its arrays are looked at?
static int is_tree_header(const Section *section)
{
    return strncmp(section->name, "tree.", 5) == 0 && strchr(section->name + 5, '.') == NULL;
}

// The answers with garbage in one section, in all of them when victim is -1.
static Sections garbled(const Section list[], int n, int victim, int kind, Random *random)
{
    Writer writer;
    writer_open(&writer);
    for (int i = 0; i < n; i++) {
        unsigned char *bytes = malloc(list[i].n_bytes + 1);
        memcpy(bytes, list[i].bytes, list[i].n_bytes);
        if (victim == i || (victim < 0 && !is_tree_header(&list[i]))) {
            fill_with_garbage(kind, random, bytes, list[i].n_bytes);
        }
        answer(&writer, list[i].name, bytes, list[i].n_bytes);
        free(bytes);
    }
    return writer_close(&writer);
}

// This one asks only whether every pixel was written, and garbage was.
static int asks_for_pixels_only(const Check *check)
{
    return strcmp(check->id, "enqueue-covers") == 0;
}

LAB_TEST(garbage_passes_no_check)
{
    Open open = job_open(*lab, 3);
    Sections answers = right_answers(*lab, &open.file);
    Section list[MAX_SECTIONS];
    const int n = list_sections(&answers, list);
    Random random = {4};
    for (int kind = 0; kind < N_KINDS; kind++) {
        Sections bad = garbled(list, n, -1, kind, &random);
        for (int i = 0; i < open.judge->n_checks; i++) {
            const Check *check = &open.judge->checks[i];
            const VerdictKind expected =
                asks_for_pixels_only(check) && kind != NOBODY ? VERDICT_PASSED : VERDICT_FAILED;
            cr_expect_eq(verdict_on(&open, i, &bad), expected, "garbage %d: %s", kind, check->id);
        }
        if (kind == RANDOM_BYTES || kind == NANS) {
            add_pictures(&open, &bad);
        }
        sections_free(&bad);
    }
    sections_free(&answers);
    job_close(&open);
}

LAB_TEST(garbage_in_one_section_is_noticed)
{
    Open open = job_open(*lab, 5);
    Sections answers = right_answers(*lab, &open.file);
    Section list[MAX_SECTIONS];
    const int n = list_sections(&answers, list);
    Random random = {6};
    for (int victim = 0; victim < n; victim++) {
        // Three kinds a section, others for the next.
        for (int kind = victim % 3; kind < N_KINDS; kind += 3) {
            // Zeros are the right picture of a scene without circles.
            if (kind == ZEROS) {
                continue;
            }
            Sections bad = garbled(list, n, victim, kind, &random);
            int n_passed = 0;
            for (int i = 0; i < open.judge->n_checks; i++) {
                n_passed += verdict_on(&open, i, &bad) == VERDICT_PASSED;
            }
            // Garbage may be what is right: the map of no circle is a zero.
            const int is_same = bad.n_bytes == answers.n_bytes &&
                                memcmp(bad.bytes, answers.bytes, bad.n_bytes) == 0;
            cr_expect(is_same || n_passed < open.judge->n_checks, "garbage %d in %s", kind,
                      list[victim].name);
            sections_free(&bad);
        }
    }
    sections_free(&answers);
    job_close(&open);
}

// Sections of which every word counts; a wrong word is the other decision, or another bit.
static const struct {
    int lab;
    const char *name;
    int is_decision;
} whole_sections[] = {
    {0, "readback.0", 0},   {0, "readback.1", 0},
    {1, "overlaps", 1},     {2, "leaves", 1},
    {2, "splits", 0},       {2, "overlaps", 1},
    {2, "distribute", 0},   {2, "pack", 0},
    {2, "tree.1.map", 0},   {2, "tree.1.relations", 0},
    {2, "tree.1.boxes", 0}, {3, "children", 0},
    {4, "axes", 0},         {5, "roots", 0},
    {5, "normals", 0},
};

static int passes_everything(const Open *open, const Sections *answers)
{
    int i = 0;
    while (i < open->judge->n_checks && verdict_on(open, i, answers) == VERDICT_PASSED) {
        i++;
    }
    return i == open->judge->n_checks;
}

LAB_TEST(one_wrong_word_is_noticed)
{
    Open open = job_open(*lab, 9);
    Sections answers = right_answers(*lab, &open.file);
    Random random = {10};
    for (size_t s = 0; s < sizeof whole_sections / sizeof *whole_sections; s++) {
        size_t n_bytes;
        u32 *words = (u32 *)sections_find_any(&answers, whole_sections[s].name, &n_bytes);
        if (whole_sections[s].lab != *lab) {
            continue;
        }
        cr_assert_not_null(words);
        size_t n_words = n_bytes / sizeof *words;
        // Of a list only what belongs to it: behind it anything may stand.
        if (strcmp(whole_sections[s].name, "distribute") == 0) {
            while (words[0] < 3) {
                words += DISTRIBUTE_ROOM;
            }
            n_words = 1 + words[0];
        }
        // Of packed leaves the first one word by word, else some words anywhere.
        const int is_pack = strcmp(whole_sections[s].name, "pack") == 0;
        const size_t n_tries = is_pack ? sizeof(PackAnswer) / sizeof *words : 40;
        for (size_t i = 0; i < n_tries; i++) {
            const size_t at =
                is_pack ? i : (size_t)random_integer(&random, 0, (int64_t)n_words - 1);
            const u32 was = words[at];
            words[at] = whole_sections[s].is_decision ? was == 0 : was ^ 0x40000000;
            cr_expect_not(passes_everything(&open, &answers), "%s: word %zu",
                          whole_sections[s].name, at);
            words[at] = was;
        }
    }
    cr_expect(passes_everything(&open, &answers));
    sections_free(&answers);
    job_close(&open);
}
