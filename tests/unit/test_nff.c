// common/scene3d_nff: scenes in the Neutral File Format, whatever the text may hold.
#include "line_reader.h"
#include "random.h"
#include "scene3d.h"
#include "surroundings.h"

#include <errno.h>
#include <limits.h>
#include <locale.h>
#include <math.h>

TestSuite(nff, .init = folder_enter, .fini = folder_leave);

// Text with its length, so that it may hold NUL bytes.
#define TEXT(literal) literal, sizeof(literal) - 1

#define VIEW "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 512 256\n"
#define SPHERE "s 1 -2.5 3 0.5\n"

static int read_text(const char *text, size_t length, Scene3D *scene)
{
    *scene = (Scene3D){0};
    FILE *file = tmpfile();
    fwrite(text, 1, length, file);
    rewind(file);
    int result = scene3d_read_nff(file, "scene.nff", scene);
    fclose(file);
    return result;
}

// Read text that is good and that nobody is warned of.
static Scene3D read_good(const char *text)
{
    Scene3D scene;
    capture_begin(2);
    int result = read_text(text, strlen(text), &scene);
    const char *message = capture_end(2);
    cr_assert_eq(result, 0, "%s", message);
    cr_expect_str_eq(message, "");
    return scene;
}

static int are_equal(Vec3 v, float x, float y, float z)
{
    return v.x == x && v.y == y && v.z == z;
}

// ---- Good text ----------------------------------------------------------------------------------

Test(nff, every_line_finds_its_place)
{
    Scene3D scene = read_good("b 0.25 0.5 1\n"
                              "v\nfrom 1 2 3\nat 4 5 6\nup 0 0.5 1\nangle 30\nhither 0.25\n"
                              "resolution 640 480\n"
                              "l 7 8 9 0.5 2 0\n"
                              "f 1 0 0.5 0.75 0.25 30 0.125 1.5\n"
                              "s 1 -2.5 3 0.5\n");
    cr_expect(are_equal(scene.background, 0.25f, 0.5f, 1));
    cr_expect(are_equal(scene.view.from, 1, 2, 3));
    cr_expect(are_equal(scene.view.at, 4, 5, 6));
    cr_expect(are_equal(scene.view.up, 0, 0.5f, 1));
    cr_expect(scene.view.angle == 30 && scene.view.hither == 0.25f);
    cr_expect(scene.width == 640 && scene.height == 480);
    cr_assert_eq(scene.n_lights, 1);
    cr_expect(are_equal(scene.lights[0].position, 7, 8, 9));
    cr_expect(are_equal(scene.lights[0].color, 0.5f, 2, 0));
    cr_assert_eq(scene.n_materials, 1);
    const Material *material = &scene.materials[0];
    cr_expect(are_equal(material->color, 1, 0, 0.5f));
    cr_expect(material->kd == 0.75f && material->ks == 0.25f && material->shine == 30);
    cr_expect(material->transmittance == 0.125f && material->refraction == 1.5f);
    cr_assert_eq(scene.n_spheres, 1);
    cr_expect_eq(scene.material_ids[0], 0);
    const Sphere *sphere = &scene.spheres[0];
    cr_expect(sphere->x == 1 && sphere->y == -2.5f && sphere->z == 3 && sphere->radius == 0.5f);
    scene3d_free(&scene);
}

// All of them hold the sphere of the test above, and nothing else that counts.
static const char *const GOOD[] = {
    VIEW SPHERE,
    VIEW "s 1 -2.5 3 0.5 ",
    "b 0 0 0\n" VIEW SPHERE,
    VIEW "b 0 0 0\n" SPHERE,
    SPHERE VIEW,
    VIEW "\n  \n# comment\n #another\n" SPHERE "\n\n",
    VIEW "s 1 -2.5 3 0.5 # with a comment\n",
    VIEW "s 1 -2.5 3 0.5 #\n",
    VIEW "s 1 -2.5 3 0.5 #one# and# another\n",
    VIEW "  s \t1   -2.5\t3 \t 0.5  \n",
    VIEW "s +1 -25e-1 3. .5\n",
    "\xEF\xBB\xBF" VIEW SPHERE,
    "v\r\nfrom 0 0 5\r\nat 0 0 0\r\nup 0 1 0\r\nangle 45\r\nhither 1\r\nresolution 512 256\r\n"
    "s 1 -2.5 3 0.5\r\n\r\n",
    "v\n# the view's lines in another order\nresolution 512 256\nup 0 1 0\n\nhither 1\n"
    "angle 45\nat 0 0 0\nfrom 0 0 5\n" SPHERE,
};

Test(nff, good_text_is_read)
{
    for (size_t i = 0; i < sizeof GOOD / sizeof GOOD[0]; i++) {
        Scene3D scene = read_good(GOOD[i]);
        cr_assert_eq(scene.n_spheres, 1, "case %zu", i);
        const Sphere expected = {1, -2.5f, 3, 0.5f};
        cr_expect_eq(memcmp(scene.spheres, &expected, sizeof expected), 0, "case %zu", i);
        cr_expect(are_equal(scene.view.from, 0, 0, 5) && scene.width == 512, "case %zu", i);
        cr_expect(are_equal(scene.background, 0, 0, 0) && scene.n_lights == 0, "case %zu", i);
        scene3d_free(&scene);
    }
}

Test(nff, a_scene_may_be_empty)
{
    Scene3D scene = read_good(VIEW);
    cr_expect(scene.n_spheres == 0 && scene.n_lights == 0 && scene.n_materials == 0);
    cr_expect(scene.spheres == NULL && scene.material_ids == NULL && scene.lights == NULL);
    scene3d_free(&scene);
}

Test(nff, a_negative_radius_is_kept)
{
    Scene3D scene = read_good(VIEW "s 0 0 0 -1\n");
    cr_expect_eq(scene.spheres[0].radius, -1);
    scene3d_free(&scene);
}

Test(nff, a_sphere_before_any_material_is_white)
{
    Scene3D scene = read_good(VIEW SPHERE SPHERE "f 1 0 0 1 0 0 0 1\n" SPHERE);
    cr_assert_eq(scene.n_materials, 2);
    cr_expect(are_equal(scene.materials[0].color, 1, 1, 1) && scene.materials[0].kd == 1);
    cr_expect(scene.material_ids[0] == 0 && scene.material_ids[1] == 0);
    cr_expect_eq(scene.material_ids[2], 1);
    scene3d_free(&scene);
}

Test(nff, equal_materials_are_one)
{
    Scene3D scene = read_good(VIEW "f 1 0 0 1 0 0 0 1\n" SPHERE "f 0 1 0 1 0 0 0 1\n" SPHERE
                                   "f 1.0 0 0 1 0 0 0 1\n" SPHERE);
    cr_expect_eq(scene.n_materials, 2);
    cr_expect(scene.material_ids[0] == 0 && scene.material_ids[1] == 1 &&
              scene.material_ids[2] == 0);
    scene3d_free(&scene);
}

Test(nff, many_materials_find_theirs_again)
{
    enum { N_MATERIALS = 3000 };
    FILE *file = tmpfile();
    fputs(VIEW, file);
    for (int i = 0; i < 2 * N_MATERIALS; i++) {
        fprintf(file, "f 1 1 1 %d 0 0 0 1\ns %d 0 0 1\n", i % N_MATERIALS, i);
    }
    rewind(file);
    Scene3D scene;
    cr_assert_eq(scene3d_read_nff(file, "scene.nff", &scene), 0);
    fclose(file);
    cr_assert_eq(scene.n_materials, N_MATERIALS);
    for (int i = 0; i < scene.n_spheres; i++) {
        cr_expect_eq(scene.material_ids[i], (u32)(i % N_MATERIALS));
    }
    scene3d_free(&scene);
}

Test(nff, lights_without_a_colour_share_the_brightness)
{
    Scene3D scene = read_good("l 1 0 0\n" VIEW "l 2 0 0 0.5 0.5 0.5\nl 3 0 0\nl 4 0 0\n");
    cr_assert_eq(scene.n_lights, 4);
    cr_expect(are_equal(scene.lights[0].color, 0.5f, 0.5f, 0.5f));  // 1 / sqrt(4)
    cr_expect(are_equal(scene.lights[1].color, 0.5f, 0.5f, 0.5f));
    scene3d_free(&scene);

    scene = read_good(VIEW "l 1 0 0\nl 2 0 0\n");
    const float expected = (float)(1 / sqrt(2));
    cr_expect(are_equal(scene.lights[1].color, expected, expected, expected));
    scene3d_free(&scene);
}

Test(nff, what_is_no_sphere_is_skipped_with_one_warning)
{
    static const char text[] = VIEW "p 3\n0 0 0\n\n1 0 0\n# comment\n0 1 0\n" SPHERE
                                    "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n"
                                    "c\n0 0 0 1\n0 0 1 0\n" SPHERE "p 3\n0 0 0\n1 0 0\n0 1 0\n";
    Scene3D scene;
    capture_begin(2);
    int result = read_text(text, sizeof text - 1, &scene);
    cr_expect_str_eq(capture_end(2), "scene.nff: warning: skipped what is no sphere: 1 c (cones), "
                                     "2 p (polygons), 1 pp (patches)\n");
    cr_assert_eq(result, 0);
    cr_expect_eq(scene.n_spheres, 2);
    scene3d_free(&scene);
}

// Haines' own programs print cones on one line, and his reader heeds no line ends in what is
// skipped.
Test(nff, numbers_of_what_is_skipped_are_a_stream)
{
    static const char *const TEXTS[] = {
        VIEW "c 0 0 0 1 0 0 1 0\n" SPHERE "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n"
             "p 3 0 0 0 1 0 0 0 1 0\n",
        VIEW "c\n0\n0 0 1 0\n0 1 # a comment\n\n0 " SPHERE
             "p\n3\n0 0 0 1\n0 0 0 1 0 pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n",
        VIEW "c 0 0 0 1\r\n 0 0 1 0\r\np 3 0 0 0 1 0 0 0 1\r\n0 " SPHERE
             "pp 3\n0 0 0\n0 0 1\n1 0 0\n0 0 1\n0 1 0\n0 0 1\n",
    };
    for (size_t i = 0; i < sizeof TEXTS / sizeof TEXTS[0]; i++) {
        Scene3D scene;
        capture_begin(2);
        int result = read_text(TEXTS[i], strlen(TEXTS[i]), &scene);
        const char *message = capture_end(2);
        cr_expect_str_eq(message, "scene.nff: warning: skipped what is no sphere: 1 c (cones), "
                                  "1 p (polygons), 1 pp (patches)\n");
        cr_assert_eq(result, 0, "case %zu", i);
        cr_expect_eq(scene.n_spheres, 1);
        scene3d_free(&scene);
    }
}

Test(nff, a_last_line_without_its_end_is_warned_of)
{
    static const char *const ENDS[] = {"s 1 -2.5 3 0.5", "s 1 -2.5 3 0.5\nl 1 2 3"};
    for (size_t i = 0; i < sizeof ENDS / sizeof ENDS[0]; i++) {
        char text[512], expected[256];
        Scene3D scene;
        snprintf(text, sizeof text, VIEW "%s", ENDS[i]);
        snprintf(
            expected, sizeof expected,
            "scene.nff: warning: the last line (%zu) has no line end: if the file was cut there, "
            "its last number is wrong\n",
            8 + i);
        capture_begin(2);
        int result = read_text(text, strlen(text), &scene);
        cr_expect_str_eq(capture_end(2), expected);
        cr_assert_eq(result, 0);
        cr_expect(scene.n_spheres == 1 && scene.spheres[0].radius == 0.5f);
        scene3d_free(&scene);
    }
}

// Outside the suite, and so in the top folder.
Test(nff_example, is_read)
{
    FILE *file = fopen("tests/scenes/example.nff", "rb");
    cr_assert_not_null(file, "start in the top folder");
    Scene3D scene;
    capture_begin(2);
    int result = scene3d_read_nff(file, "example.nff", &scene);
    expect_one_message(capture_end(2), "example.nff: warning: skipped");
    fclose(file);
    cr_assert_eq(result, 0);
    cr_expect(scene.n_spheres == 7 && scene.n_lights == 3 && scene.n_materials == 6);
    scene3d_free(&scene);
}

// "de_DE" has a decimal comma, and need not be installed.
Test(nff, the_locale_plays_no_part)
{
    if (setlocale(LC_ALL, "de_DE.UTF-8") == NULL) {
        SKIP_TEST("no locale with a decimal comma is installed");
    }
    Scene3D scene = read_good(VIEW SPHERE);
    cr_expect_eq(scene.spheres[0].y, -2.5f);
    scene3d_free(&scene);
}

// ---- Bad text -----------------------------------------------------------------------------------

// The view is 7 lines, so what follows it begins at line 8.
static const struct {
    const char *text;
    size_t length;
    const char *message;
} BAD[] = {
    {TEXT(""), "1: found the end of the file, expected a view, which begins with \"v\""},
    {TEXT("\n# nothing\n"),
     "3: found the end of the file, expected a view, which begins with \"v\""},
    {TEXT(SPHERE), "2: found the end of the file, expected a view, which begins with \"v\""},
    {TEXT("v\n"), "2: found the end of the file, expected the view's line \"from\""},
    {TEXT("v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\n"),
     "7: found the end of the file, expected the view's line \"resolution\""},
    {TEXT("v\nfrom 0 0 5\nup 0 1 0\n" SPHERE), "4: found \"s\", expected the view's line \"at\""},
    {TEXT("v\nfrom 0 0 5\nv\n"), "3: found \"v\", expected the view's line \"at\""},
    {TEXT("v\nfrom 0 0 5\nfrom 0 0 5\n"), "3: found \"from\", expected one line \"from\""},
    {TEXT("from 0 0 5\n"), "1: found \"from\", expected \"v\" before it"},
    {TEXT(VIEW "resolution 1 1\n"), "8: found \"resolution\", expected one line \"resolution\""},
    {TEXT(VIEW VIEW), "8: found \"v\", expected one line \"v\""},
    {TEXT("b 0 0 0\n" VIEW "b 0 0 0\n"), "9: found \"b\", expected one line \"b\""},
    {TEXT("v 1\n"), "1: found v and 1 word, expected v"},
    {TEXT(VIEW "x 1 2 3\n"), "8: found \"x\", expected b, v, l, f, s, c, p, pp or #"},
    {TEXT(VIEW "S 1 2 3 4\n"), "8: found \"S\", expected b, v, l, f, s, c, p, pp or #"},
    {TEXT(VIEW "s1 2 3 4\n"), "8: found \"s1\", expected b, v, l, f, s, c, p, pp or #"},
    {TEXT(VIEW "1 2 3\n"), "8: found \"1\", expected b, v, l, f, s, c, p, pp or #"},
    {TEXT(VIEW "s 1 2 3\n"), "8: found s and 3 words, expected s x y z radius"},
    {TEXT(VIEW "s 1 2 3 # 4\n"), "8: found s and 3 words, expected s x y z radius"},
    {TEXT(VIEW "s\n"), "8: found s and 0 words, expected s x y z radius"},
    {TEXT(VIEW "s 1 2 3 4 5\n"), "8: found s and 5 words, expected s x y z radius"},
    {TEXT(VIEW "s 1 2 3 4 5 6 7 8 9 10 11 12\n"),
     "8: found s and 12 words, expected s x y z radius"},
    {TEXT(VIEW "b 1 2\n"), "8: found b and 2 words, expected b r g b"},
    {TEXT(VIEW "l 1 2\n"), "8: found l and 2 words, expected l x y z [r g b]"},
    {TEXT(VIEW "l 1 2 3 4\n"), "8: found l and 4 words, expected l x y z [r g b]"},
    {TEXT(VIEW "f 1 1 1 1 1\n"),
     "8: found f and 5 words, expected f r g b Kd Ks Shine T refraction"},
    {TEXT("v\nangle\n"), "2: found angle and 0 words, expected angle degrees"},
    {TEXT(VIEW SPHERE "s 1 2 3 0\n"),
     "9: radius: found \"0\", expected a finite number other than 0 in float"},
    {TEXT(VIEW "s 1 2 3 -0.0\n"),
     "8: radius: found \"-0.0\", expected a finite number other than 0 in float"},
    {TEXT(VIEW "s 1 2 3 1e-60\n"),
     "8: radius: found \"1e-60\", expected a finite number other than 0 in float"},
    {TEXT(VIEW "s nan 2 3 4\n"), "8: x: found \"nan\", expected a finite number"},
    {TEXT(VIEW "s 1 -inf 3 4\n"), "8: y: found \"-inf\", expected a finite number"},
    {TEXT(VIEW "s 1 2 1e39 4\n"), "8: z: found \"1e39\", expected a finite number"},
    {TEXT(VIEW "s 1 2 0x10 4\n"), "8: z: found \"0x10\", expected a finite number"},
    {TEXT(VIEW "s 1 2 3,5 4\n"), "8: z: found \"3,5\", expected a finite number"},
    {TEXT(VIEW "s 1 2 3 nan\n"),
     "8: radius: found \"nan\", expected a finite number other than 0 in float"},
    {TEXT(VIEW "s 1 2 3 -inf\n"),
     "8: radius: found \"-inf\", expected a finite number other than 0 in float"},
    {TEXT(VIEW "s 1 2 1.#QNAN 4\n"),
     "8: found \"1.#QNAN\", expected a blank before a comment's #, and no other #"},
    {TEXT(VIEW "s 1 2 3 1.#INF\n"),
     "8: found \"1.#INF\", expected a blank before a comment's #, and no other #"},
    {TEXT(VIEW SPHERE "s 0 0 0 1# glued\n"),
     "9: found \"1#\", expected a blank before a comment's #, and no other #"},
    {TEXT(VIEW "p 3\n0 0 0 1 0 0 0 1 0# glued\n"),
     "9: found \"0#\", expected a blank before a comment's #, and no other #"},
    {TEXT(VIEW "s 1 2 3 4abc\n"),
     "8: radius: found \"4abc\", expected a finite number other than 0 in float"},
    {TEXT(VIEW "s 1 2 3 \033[31m4\n"),
     "8: radius: found \"?[31m4\", expected a finite number other than 0 in float"},
    {TEXT(VIEW "s 1 2 3 \xFF\n"),
     "8: radius: found \"?\", expected a finite number other than 0 in float"},
    {TEXT(VIEW "s 1 2 3 11111111111111111111111111111111111111111111111111\n"),
     "8: radius: found \"1111111111111111111111111111111111111111...\", expected a finite "
     "number other than 0 in float"},
    {TEXT(VIEW "b 0 0 255\n"), "8: b: found \"255\", expected a number from 0 to 1"},
    {TEXT(VIEW "b -0.1 0 0\n"), "8: r: found \"-0.1\", expected a number from 0 to 1"},
    {TEXT(VIEW "f 0 1.5 0 1 0 0 0 1\n"), "8: g: found \"1.5\", expected a number from 0 to 1"},
    {TEXT(VIEW "f 0 0 0 -1 0 0 0 1\n"),
     "8: Kd: found \"-1\", expected a finite number of at least 0"},
    {TEXT(VIEW "f 0 0 0 1 0 0 0 nan\n"),
     "8: refraction: found \"nan\", expected a finite number of at least 0"},
    {TEXT(VIEW "l 0 0 0 -1 0 0\n"), "8: r: found \"-1\", expected a finite number of at least 0"},
    {TEXT("v\nangle 0\n"), "2: degrees: found \"0\", expected an angle between 0 and 180 degrees"},
    {TEXT("v\nangle 180\n"),
     "2: degrees: found \"180\", expected an angle between 0 and 180 degrees"},
    {TEXT("v\nhither -1\n"), "2: distance: found \"-1\", expected a finite number of at least 0"},
    {TEXT("v\nresolution 0 9\n"),
     "2: width: found \"0\", expected a whole number from 1 to 1000000"},
    {TEXT("v\nresolution 9 2.5\n"),
     "2: height: found \"2.5\", expected a whole number from 1 to 1000000"},
    {TEXT("v\nresolution 9 1000001\n"),
     "2: height: found \"1000001\", expected a whole number from 1 to 1000000"},
    {TEXT("v\nfrom 1 2 3\nat 1 2 3\nup 0 1 0\nangle 45\nhither 1\nresolution 2 2\n"),
     "7: view: found the view's direction is zero (from is at), expected a view that a camera can "
     "have"},
    {TEXT("v\nfrom 0 2 0\nat 0 0 0\nup 0 1 0\nangle 45\nresolution 2 2\nhither 1\n" SPHERE),
     "7: view: found up is parallel to the view, expected a view that a camera can have"},
    {TEXT("v\nfrom 0 2 0\nat 0 0 0\nup 0 0 0\nangle 45\nresolution 2 2\nhither 1\n"),
     "7: view: found up is zero, expected a view that a camera can have"},
    {TEXT("v\nfrom 0 2e38 0\nat 0 0 0\nup 0 0 1\nangle 45\nresolution 2 2\nhither 1\n"),
     "7: view: found the view's direction or up is too short or too long (1e-32 to 1e32), expected "
     "a view that a camera can have"},
    {TEXT(VIEW "p 2\n"), "8: p: found \"2\", expected a number of corners from 3 to 10000000"},
    {TEXT(VIEW "p 99999999999\n"),
     "8: p: found \"99999999999\", expected a number of corners from 3 to 10000000"},
    {TEXT(VIEW "p -3\n"), "8: p: found \"-3\", expected a number of corners from 3 to 10000000"},
    {TEXT(VIEW "p\n\n2\n"), "10: p: found \"2\", expected a number of corners from 3 to 10000000"},
    {TEXT(VIEW "p\n"), "9: found the end of the file, expected 1 more number of \"p\""},
    {TEXT(VIEW "p 3\n0 0 0\n1 0\n"),
     "11: found the end of the file, expected 4 more numbers of \"p\""},
    {TEXT(VIEW "p 3\n0 0 0\n1 0 0\n0 1\n" SPHERE),
     "12: p: found \"s\", expected a finite number, as 1 more belongs to it"},
    {TEXT(VIEW "pp 3\n0 0 0 0 0 1\n"),
     "10: found the end of the file, expected 12 more numbers of \"pp\""},
    {TEXT(VIEW "c\n0 0 0 1\n"), "10: found the end of the file, expected 4 more numbers of \"c\""},
    {TEXT(VIEW "c 0 0 0 1 0 0 1\n" SPHERE),
     "9: c: found \"s\", expected a finite number, as 1 more belongs to it"},
    {TEXT(VIEW "c\n0 0 zero 1\n"),
     "9: c: found \"zero\", expected a finite number, as 6 more belong to it"},
    {TEXT(VIEW "c 0 0 0 1 0 0 1 1 1\n"), "8: found \"1\", expected b, v, l, f, s, c, p, pp or #"},
    {TEXT(VIEW "s 1 2\0 3 4\n"), "8: found a NUL byte, expected text"},
    {TEXT("\x89PNG\r\n\x1a\n"), "1: found \"?PNG\", expected b, v, l, f, s, c, p, pp or #"},
};

Test(nff, bad_text_gives_one_message_with_its_line)
{
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        Scene3D scene;
        char expected[256];
        capture_begin(2);
        int result = read_text(BAD[i].text, BAD[i].length, &scene);
        const char *message = capture_end(2);
        snprintf(expected, sizeof expected, "scene.nff:%s\n", BAD[i].message);
        cr_expect_str_eq(message, expected);
        cr_expect_eq(result, -1, "case %zu was read: %s", i, BAD[i].message);
        cr_expect_null(scene.spheres);
    }
}

Test(nff, a_line_ends_somewhere)
{
    static char text[2 * LINE_MAX_LENGTH];
    memset(text, ' ', sizeof text);
    memcpy(text, VIEW, sizeof VIEW - 1);
    const size_t start = sizeof VIEW - 1;
    text[start] = '#';
    for (int is_too_long = 0; is_too_long < 2; is_too_long++) {
        Scene3D scene;
        capture_begin(2);
        int result = read_text(text, start + LINE_MAX_LENGTH + (size_t)is_too_long, &scene);
        cr_expect_str_eq(capture_end(2), is_too_long ? "scene.nff:8: found more than 4096 "
                                                       "characters, expected a shorter line\n"
                                                     : "");
        cr_expect_eq(result, -is_too_long);
        scene3d_free(&scene);
    }
}

Test(nff, lights_have_a_limit)
{
    for (int n_lights = SCENE3D_MAX_LIGHTS; n_lights <= SCENE3D_MAX_LIGHTS + 1; n_lights++) {
        FILE *file = tmpfile();
        fputs(VIEW, file);
        for (int i = 0; i < n_lights; i++) {
            fputs("l 0 0 0\n", file);
        }
        rewind(file);
        Scene3D scene = {0};
        capture_begin(2);
        int result = scene3d_read_nff(file, "scene.nff", &scene);
        cr_expect_str_eq(capture_end(2),
                         n_lights > SCENE3D_MAX_LIGHTS
                             ? "scene.nff:1008: found more lights, expected at most 1000\n"
                             : "");
        cr_expect_eq(result, n_lights > SCENE3D_MAX_LIGHTS ? -1 : 0);
        fclose(file);
        scene3d_free(&scene);
    }
}

Test(nff, a_folder_cannot_be_read)
{
    FILE *folder = fopen(".", "rb");
    cr_assert_not_null(folder);
    Scene3D scene = {0};
    capture_begin(2);
    int result = scene3d_read_nff(folder, "folder.nff", &scene);
    expect_one_message(capture_end(2), strerror(EISDIR));
    cr_expect_eq(result, -1);
    fclose(folder);
}

// Wherever a download stops: a scene, or one message.
Test(nff, cut_anywhere)
{
    static const char text[] =
        "# comment\r\nb 0.1 0.2 0.3\r\n" VIEW "l 1 2 3\nl 1 2 3 0.5 0.5 0.5\n"
        "f 1 0.5 0.25 1 0 10 0 1\ns 1 2 3 -4.5\np 3\n0 0 0\n1 0 0\n0 1 0\n"
        "c\n0 0 0 1\n0 0 1 0\npp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n"
        "0 1 0 0 0 1\ns 4 5 6 7e-1\n";
    int n_read = 0;
    for (size_t length = 0; length < sizeof text; length++) {
        Scene3D scene;
        capture_begin(2);
        int result = read_text(text, length, &scene);
        const char *message = capture_end(2);
        if (result != 0 || message[0] != '\0') {
            expect_one_message(message, result == 0 ? "scene.nff: warning: " : "scene.nff:");
        }
        n_read += result == 0;
        scene3d_free(&scene);
    }
    cr_expect_gt(n_read, 10);
}

// ---- Writing ------------------------------------------------------------------------------------

// Any finite float, of any size.
static float random_float(Random *random)
{
    float number;
    do {
        uint32_t bits = (uint32_t)random_bits(random);
        memcpy(&number, &bits, sizeof number);
    } while (!isfinite(number));
    return number;
}

static float random_positive(Random *random)
{
    return fabsf(random_float(random));
}

// A length that a view can have.
static float random_length(Random *random)
{
    return fminf(fmaxf(random_positive(random), 1e-30f), 1e30f);
}

static float random_share(Random *random)
{
    return (float)random_integer(random, 0, INT_MAX) / (float)INT_MAX;
}

static Vec3 random_color(Random *random)
{
    return (Vec3){random_share(random), random_share(random), random_share(random)};
}

static Vec3 random_point(Random *random)
{
    return (Vec3){random_float(random), random_float(random), random_float(random)};
}

#define MAX_ROUND_TRIP 40

// Where a random scene's arrays lie. Its materials differ, and are used in any order or not at all.
typedef struct Room {
    Sphere spheres[MAX_ROUND_TRIP];
    u32 material_ids[MAX_ROUND_TRIP];
    Material materials[MAX_ROUND_TRIP];
    Light lights[MAX_ROUND_TRIP];
} Room;

static Scene3D random_scene(Random *random, Room *room)
{
    Scene3D scene = {
        .spheres = room->spheres,
        .material_ids = room->material_ids,
        .materials = room->materials,
        .lights = room->lights,
        .n_spheres = (int)random_integer(random, 0, MAX_ROUND_TRIP),
        .n_materials = (int)random_integer(random, 1, MAX_ROUND_TRIP),
        .n_lights = (int)random_integer(random, 0, MAX_ROUND_TRIP),
        .background = random_color(random),
        .view = {{0, 0, random_length(random)},
                 {0, 0, 0},
                 {0, random_length(random), 0},
                 179 * random_share(random) + 1e-6f,
                 random_positive(random)},
        .width = (int)random_integer(random, 1, 1000000),
        .height = (int)random_integer(random, 1, 1000000),
    };
    for (int i = 0; i < scene.n_spheres; i++) {
        const Vec3 center = random_point(random);
        room->spheres[i] =
            (Sphere){center.x, center.y, center.z, i % 5 == 0 ? -1e-45f : random_float(random)};
        room->material_ids[i] = (u32)random_integer(random, 0, scene.n_materials - 1);
    }
    for (int i = 0; i < scene.n_materials; i++) {
        room->materials[i] = (Material){random_color(random),    random_positive(random),
                                        random_positive(random), (float)i,
                                        random_share(random),    random_positive(random)};
    }
    for (int i = 0; i < scene.n_lights; i++) {
        room->lights[i] = (Light){random_point(random), random_color(random)};
    }
    return scene;
}

static int arrays_are_equal(const void *a, const void *b, int n_entries, size_t entry_size)
{
    return n_entries == 0 || memcmp(a, b, (size_t)n_entries * entry_size) == 0;
}

static void expect_same(const Scene3D *a, const Scene3D *b)
{
    cr_assert(a->n_spheres == b->n_spheres && a->n_materials == b->n_materials &&
              a->n_lights == b->n_lights);
    cr_expect(arrays_are_equal(a->spheres, b->spheres, a->n_spheres, sizeof(Sphere)));
    cr_expect(arrays_are_equal(a->material_ids, b->material_ids, a->n_spheres, sizeof(u32)));
    cr_expect(arrays_are_equal(a->materials, b->materials, a->n_materials, sizeof(Material)));
    cr_expect(arrays_are_equal(a->lights, b->lights, a->n_lights, sizeof(Light)));
    cr_expect_eq(memcmp(&a->background, &b->background, sizeof a->background), 0);
    cr_expect_eq(memcmp(&a->view, &b->view, sizeof a->view), 0);
    cr_expect(a->width == b->width && a->height == b->height);
}

Test(nff, what_is_written_reads_back_to_the_bit)
{
    Random random = {1};
    for (int round = 0; round < 500; round++) {
        Room room;
        const Scene3D scene = random_scene(&random, &room);
        FILE *file = tmpfile();
        cr_assert_eq(scene3d_write_nff(file, &scene), 0);
        rewind(file);
        Scene3D again;
        cr_assert_eq(scene3d_read_nff(file, "again.nff", &again), 0, "round %d", round);
        fclose(file);
        expect_same(&scene, &again);
        scene3d_free(&again);
    }
}

Test(nff, what_is_written_is_what_people_write)
{
    char *text = NULL;
    size_t length = 0;
    FILE *file = open_memstream(&text, &length);
    Scene3D scene = read_good("v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\n"
                              "resolution 512 256\nl 1 2 3\nf 1 0 0 1 0 0 0 1\n" SPHERE
                              "f 0 0.1 0 1 0 0 0 1\n" SPHERE SPHERE "f 1 0 0 1 0 0 0 1\n" SPHERE);
    cr_assert_eq(scene3d_write_nff(file, &scene), 0);
    fclose(file);
    cr_expect_str_eq(text, "b 0 0 0\n" VIEW "l 1 2 3 1 1 1\nf 1 0 0 1 0 0 0 1\n" SPHERE
                           "f 0 0.1 0 1 0 0 0 1\n" SPHERE SPHERE "f 1 0 0 1 0 0 0 1\n" SPHERE);
    free(text);
    scene3d_free(&scene);
}

Test(nff, a_full_disk_is_noticed)
{
    FILE *full = fopen("/dev/full", "w");
    if (full == NULL) {
        SKIP_TEST("this system has no /dev/full");
    }
    setvbuf(full, NULL, _IONBF, 0);
    Scene3D scene = {0};
    cr_expect_eq(scene3d_write_nff(full, &scene), -1);
    fclose(full);
}

// ---- Large files --------------------------------------------------------------------------------

Test(nff, a_million_spheres_take_seconds)
{
    FILE *file = tmpfile();
    fputs(VIEW, file);
    for (int i = 0; i < 1000000; i++) {
        fprintf(file, "s %d.0625 12.5 3.25 0.5\n", i % 1000);
    }
    rewind(file);
    Scene3D scene;
    cr_assert_eq(scene3d_read_nff(file, "scene.nff", &scene), 0);
    fclose(file);
    cr_expect_eq(scene.n_spheres, 1000000);
    scene3d_free(&scene);
}

// That a file says how long it is, is no reason to believe it.
Test(nff, a_count_is_not_believed)
{
    FILE *file = tmpfile();
    fputs(VIEW "p 10000000\n", file);
    for (int i = 0; i < 1000; i++) {
        fputs("1 2 3\n", file);
    }
    rewind(file);
    Scene3D scene;
    capture_begin(2);
    cr_expect_eq(scene3d_read_nff(file, "scene.nff", &scene), -1);
    cr_expect_str_eq(
        capture_end(2),
        "scene.nff:1009: found the end of the file, expected 29997000 more numbers of \"p\"\n");
    fclose(file);
}
