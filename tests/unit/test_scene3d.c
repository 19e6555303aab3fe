// common/scene3d: scenes by name. What every generated scene must be, the size of the picture, and
// what is said of names that are none.
#include "scene3d_samples.h"

TestSuite(scene3d, .init = folder_enter, .fini = folder_leave);

// ---- Every generated scene ----------------------------------------------------------------------

static int is_share(float value)
{
    return value >= 0 && value <= 1;
}

static void expect_well_formed(const Scene3D *scene, const char *name)
{
    for (int i = 0; i < scene->n_spheres; i++) {
        const Sphere *sphere = &scene->spheres[i];
        cr_assert(isfinite(sphere->x) && isfinite(sphere->y) && isfinite(sphere->z) &&
                      isfinite(sphere->radius) && sphere->radius != 0,
                  "%s: sphere %d", name, i);
        cr_assert_lt(scene->material_ids[i], (u32)scene->n_materials, "%s: sphere %d", name, i);
    }
    for (int i = 0; i < scene->n_materials; i++) {
        const Material *material = &scene->materials[i];
        cr_assert(is_share(material->color.x) && is_share(material->color.y) &&
                      is_share(material->color.z) && is_share(material->kd) &&
                      is_share(material->ks) && material->kd > 0,
                  "%s: material %d", name, i);
    }
    cr_expect_gt(scene->n_lights, 0, "%s", name);
    for (int i = 0; i < scene->n_lights; i++) {
        float brightness = (float)(1 / sqrt(scene->n_lights));
        cr_expect_eq(scene->lights[i].color.x, brightness, "%s: light %d", name, i);
    }
    cr_expect_null(scene3d_view_fault(&scene->view), "%s", name);
    cr_expect(scene->view.angle > 0 && scene->view.angle < 180, "%s", name);
    cr_expect_eq(scene->spheres == NULL, scene->n_spheres == 0, "%s", name);
}

// FNV-1a over spheres, materials and what spheres are made of.
static uint64_t bytes_add(uint64_t sum, const void *bytes, size_t n_bytes)
{
    for (size_t i = 0; i < n_bytes; i++) {
        sum = (sum ^ ((const unsigned char *)bytes)[i]) * 0x100000001b3u;
    }
    return sum;
}

static uint64_t scene_checksum(const Scene3D *scene)
{
    const size_t n_spheres = (size_t)scene->n_spheres;
    uint64_t sum = 0xcbf29ce484222325u;
    sum = bytes_add(sum, scene->spheres, n_spheres * sizeof *scene->spheres);
    sum = bytes_add(sum, scene->material_ids, n_spheres * sizeof *scene->material_ids);
    sum = bytes_add(sum, scene->materials, (size_t)scene->n_materials * sizeof *scene->materials);
    sum = bytes_add(sum, scene->lights, (size_t)scene->n_lights * sizeof *scene->lights);
    return bytes_add(sum, &scene->view, sizeof scene->view);
}

// The numbers are pinned: a change of a generator would change every picture of its scenes,
// reference images and bench figures among them, and must not slip in unseen.
static const struct {
    const char *name;
    int n_spheres;
    uint64_t checksum;
} GENERATED[] = {
    {"sphereflake:size=3", 820, 0xe6826aa33c4760b6u},
    {"random", 1000, 0xb30c7f1c8cf2091cu},
    {"random:n=100,seed=3", 100, 0xde902f3573096429u},
    {"lattice:n=3", 27, 0x141fca282d5b1618u},
    {"clusters:n=100", 100, 0x491737d6290201afu},
    {"stadium:n=100,seed=2", 100, 0xd371579d63ab5b41u},
    {"inside", 49, 0x5bb56fe526576247u},
    {"planes", 106, 0xc22806ef8eccb5dfu},
    {"one-cell", 251, 0x2bb7c4e989c9d2a1u},
    {"one", 1, 0xa0848c3c3c17fe66u},
    {"none", 0, 0x7432fa78cb08835fu},
    {"coincident", 192, 0x887a9e9a2be34a52u},
    {"large-small", 259, 0x7f4f203dbe39bf73u},
    {"behind", 61, 0xe663060a24efbcb7u},
};

Test(scene3d, generated_scenes_are_well_formed_and_the_same_everywhere)
{
    for (size_t i = 0; i < sizeof GENERATED / sizeof GENERATED[0]; i++) {
        const char *name = GENERATED[i].name;
        Scene3D scene = scene_open(name);
        Scene3D again = scene_open(name);
        expect_well_formed(&scene, name);
        cr_expect_eq(scene.n_spheres, GENERATED[i].n_spheres, "%s: %d", name, scene.n_spheres);
        cr_expect_eq(scene_checksum(&scene), GENERATED[i].checksum, "%s: 0x%016llx", name,
                     (unsigned long long)scene_checksum(&scene));
        cr_expect_eq(scene_checksum(&again), scene_checksum(&scene), "%s", name);
        scene3d_free(&scene);
        scene3d_free(&again);
    }
}

Test(scene3d, freed_twice_is_fine)
{
    Scene3D scene = scene_open("one");
    scene3d_free(&scene);
    cr_expect_null(scene.spheres);
    cr_expect_eq(scene.n_lights, 0);
    scene3d_free(&scene);
}

// ---- The picture's size -------------------------------------------------------------------------

#define NFF_WITHOUT_LIGHT                                                                          \
    "v\nfrom 3 1 2\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 40 30\n"                    \
    "b 0 0 0\nf 1 1 1 1 0 0 0 1\ns 0 0 0 1\n"

static void expect_size(const char *name, int width, int height, int real_width, int real_height)
{
    Scene3D scene;
    cr_assert_eq(scene3d_open(name, width, height, &scene), 0, "%s", name);
    cr_expect(scene.width == real_width && scene.height == real_height, "%s: %dx%d", name,
              scene.width, scene.height);
    scene3d_free(&scene);
}

Test(scene3d, the_users_size_goes_before_the_scenes)
{
    file_write("scene.nff", NFF_WITHOUT_LIGHT, strlen(NFF_WITHOUT_LIGHT));
    expect_size("random:n=1", 0, 0, SCENE3D_DEFAULT_SIZE, SCENE3D_DEFAULT_SIZE);
    expect_size("random:n=1", 20, 10, 20, 10);
    expect_size("planes", 0, 0, 65, 49);
    expect_size("planes", 20, 10, 20, 10);
    expect_size("scene.nff", 0, 0, 40, 30);
    expect_size("scene.nff", 20, 10, 20, 10);
}

Test(scene3d, a_scene_without_light_gets_one_at_the_eye)
{
    file_write("scene.nff", NFF_WITHOUT_LIGHT, strlen(NFF_WITHOUT_LIGHT));
    Scene3D scene = scene_open("scene.nff");
    cr_assert_eq(scene.n_lights, 1);
    const Light *light = &scene.lights[0];
    cr_expect(light->position.x == 3 && light->position.y == 1 && light->position.z == 2);
    cr_expect(light->color.x == 1 && light->color.y == 1 && light->color.z == 1);
    scene3d_free(&scene);
}

// ---- Names that are none ------------------------------------------------------------------------

static const struct {
    const char *name;
    const char *message;
} BAD[] = {
    {"sphere", "--scene sphere: found no such scene, expected FILE.nff, FILE.pdb, FILE.xyz"},
    {"sphere",
     "sphereflake[:size=N], random[:n=N,seed=S,min=R,max=R], lattice[:n=N], clusters[:n=N,seed=S], "
     "stadium[:n=N,seed=S], inside"},
    {"sphere", "large-small, behind"},
    {"", "found no such scene"},
    {".nff", "found no such scene"},
    {"Inside", "found no such scene"},
    {"one:n=1", "found no such scene"},
    {"randomly", "found no such scene"},
    {"scene.csv", "found no such scene"},
    {"missing.nff", "missing.nff: cannot be read: "},
    {"MISSING.NFF", "MISSING.NFF: cannot be read: "},
    {"missing.Pdb", "missing.Pdb: cannot be read: "},
    {"missing.pdb", "missing.pdb: cannot be read: "},
    {"missing.xyz", "missing.xyz: cannot be read: "},
    {"empty.nff", "empty.nff"},
    {"empty.pdb", "empty.pdb"},
    {"empty.xyz", "empty.xyz"},
    {"folder.nff", "folder.nff"},
    {"sphereflake:", "found \"\", expected size=N"},
    {"sphereflake:8", "found \"8\", expected size=N"},
    {"sphereflake:size=8", "found \"size=8\", expected size=N, a whole number from 0 to 7"},
    {"sphereflake:size=-1", "found \"size=-1\""},
    {"sphereflake:n=1", "found \"n=1\""},
    {"lattice:n=0", "found \"n=0\", expected n=N, a whole number from 1 to 215"},
    {"lattice:n=216", "found \"n=216\""},
    {"lattice:size=2", "found \"size=2\", expected n=N"},
    {"random:", "n=N, seed=S, min=R or max=R"},
    {"random:n=", "found \"n=\""},
    {"random:n=-1", "found \"n=-1\""},
    {"random:n=1e3", "found \"n=1e3\""},
    {"random:n=10000001", "expected n=N, a whole number from 0 to 10000000"},
    {"random:n=1,,seed=2", "found \"\""},
    {"random:n=1,", "found \"\""},
    {"random:seed=-1", "found \"seed=-1\", expected seed=S, a whole number of at least 0"},
    {"random:min=0", "found \"min=0\", expected min=R, a radius from 0.000001 to 1000"},
    {"random:min=-1", "found \"min=-1\""},
    {"random:max=1001", "found \"max=1001\", expected max=R, a radius from 0.000001 to 1000"},
    {"random:max=nan", "found \"max=nan\""},
    {"random:max=inf", "found \"max=inf\""},
    {"random:min=5,max=4", "found min=5 above max=4, expected at most that"},
    {"random:n=8,min=0.5", "min=0.5 above max=0.4"},
    {"random:n=5,n=6", "found \"n=6\", expected each argument once"},
    {"random:seed=5,n=6,seed=5", "found \"seed=5\", expected each argument once"},
    {"random:n=5,n=x", "found \"n=x\", expected each argument once"},
};

// As long as a word on a command line may be.
Test(scene3d, however_long_a_bad_name_the_reason_is_told)
{
    static char name[131000];
    static const struct {
        const char *ending, *message;
    } CASES[] = {
        {"", ": found no such scene, expected "},
        {".nff", ": cannot be read: "},
        {":n=1", ": found no such scene, expected "},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        memset(name, 'n', sizeof name - 1);
        strcpy(name + sizeof name - 1 - strlen(CASES[i].ending), CASES[i].ending);
        Scene3D scene;
        cr_expect_eq(WITH_MESSAGE(CASES[i].message, scene3d_open(name, 0, 0, &scene)), -1);
    }
    memcpy(name, "random:", strlen("random:"));
    Scene3D scene;
    cr_expect_eq(
        WITH_MESSAGE("\", expected n=N, seed=S, min=R or max=R", scene3d_open(name, 0, 0, &scene)),
        -1);
}

Test(scene3d, bad_names_give_one_message)
{
    mkdir("folder.nff", 0777);
    file_write("empty.nff", "", 0);
    file_write("empty.pdb", "", 0);
    file_write("empty.xyz", "", 0);
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        Scene3D scene;
        cr_expect_eq(WITH_MESSAGE(BAD[i].message, scene3d_open(BAD[i].name, 0, 0, &scene)), -1,
                     "%s was opened", BAD[i].name);
        cr_expect(scene.spheres == NULL && scene.lights == NULL && scene.n_spheres == 0);
    }
}
