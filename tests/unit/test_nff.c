// common/scene3d_nff: every line of the Neutral File Format finds its place in the scene, and files
// may be written in many ways. Bad text is test_nff_faults.c's matter.
#include "nff_samples.h"

#include <locale.h>
#include <math.h>

TestSuite(nff, .init = folder_enter, .fini = folder_leave);

Test(nff, every_line_finds_its_place)
{
    Scene3D scene = read_good(scene3d_read_nff,
                              "b 0.25 0.5 1\n"
                              "v\nfrom 1 2 3\nat 4 5 6\nup 0 0.5 1\nangle 30\nhither 0.25\n"
                              "resolution 640 480\n"
                              "l 7 8 9 0.5 2 0\n"
                              "f 1 0 0.5 0.75 0.25 30 0.125 1.5\n"
                              "s 1 -2.5 3 0.5\n",
                              "");
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
        Scene3D scene = read_good(scene3d_read_nff, GOOD[i], "");
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
    Scene3D scene = read_good(scene3d_read_nff, VIEW, "");
    cr_expect(scene.n_spheres == 0 && scene.n_lights == 0 && scene.n_materials == 0);
    cr_expect(scene.spheres == NULL && scene.material_ids == NULL && scene.lights == NULL);
    scene3d_free(&scene);
}

Test(nff, a_negative_radius_is_kept)
{
    Scene3D scene = read_good(scene3d_read_nff, VIEW "s 0 0 0 -1\n", "");
    cr_expect_eq(scene.spheres[0].radius, -1);
    scene3d_free(&scene);
}

Test(nff, a_sphere_before_any_material_is_white)
{
    Scene3D scene =
        read_good(scene3d_read_nff, VIEW SPHERE SPHERE "f 1 0 0 1 0 0 0 1\n" SPHERE, "");
    cr_assert_eq(scene.n_materials, 2);
    cr_expect(are_equal(scene.materials[0].color, 1, 1, 1) && scene.materials[0].kd == 1);
    cr_expect(scene.material_ids[0] == 0 && scene.material_ids[1] == 0);
    cr_expect_eq(scene.material_ids[2], 1);
    scene3d_free(&scene);
}

Test(nff, equal_materials_are_one)
{
    Scene3D scene = read_good(scene3d_read_nff,
                              VIEW "f 1 0 0 1 0 0 0 1\n" SPHERE "f 0 1 0 1 0 0 0 1\n" SPHERE
                                   "f 1.0 0 0 1 0 0 0 1\n" SPHERE,
                              "");
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
    Scene3D scene =
        read_good(scene3d_read_nff, "l 1 0 0\n" VIEW "l 2 0 0 0.5 0.5 0.5\nl 3 0 0\nl 4 0 0\n", "");
    cr_assert_eq(scene.n_lights, 4);
    cr_expect(are_equal(scene.lights[0].color, 0.5f, 0.5f, 0.5f));  // 1 / sqrt(4)
    cr_expect(are_equal(scene.lights[1].color, 0.5f, 0.5f, 0.5f));
    scene3d_free(&scene);

    scene = read_good(scene3d_read_nff, VIEW "l 1 0 0\nl 2 0 0\n", "");
    const float expected = (float)(1 / sqrt(2));
    cr_expect(are_equal(scene.lights[1].color, expected, expected, expected));
    scene3d_free(&scene);
}

Test(nff, what_is_no_sphere_is_skipped_with_one_warning)
{
    static const char text[] = VIEW "p 3\n0 0 0\n\n1 0 0\n# comment\n0 1 0\n" SPHERE
                                    "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n"
                                    "c\n0 0 0 1\n0 0 1 0\n" SPHERE "p 3\n0 0 0\n1 0 0\n0 1 0\n";
    Scene3D scene = read_good(scene3d_read_nff, text,
                              "scene.nff: warning: skipped what is no sphere: 1 c (cones), "
                              "2 p (polygons), 1 pp (patches)\n");
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
        Scene3D scene = read_good(scene3d_read_nff, TEXTS[i],
                                  "scene.nff: warning: skipped what is no sphere: 1 c (cones), "
                                  "1 p (polygons), 1 pp (patches)\n");
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
        scene = read_good(scene3d_read_nff, text, expected);
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
    Scene3D scene = read_good(scene3d_read_nff, VIEW SPHERE, "");
    cr_expect_eq(scene.spheres[0].y, -2.5f);
    scene3d_free(&scene);
}
