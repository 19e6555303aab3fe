// common/scene3d_nff: whatever the text may hold, a fault gives one message that names its line.
#include "line_reader.h"
#include "nff_samples.h"

#include <errno.h>

TestSuite(nff_faults, .init = folder_enter, .fini = folder_leave);

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
     "9: radius: found \"0\", expected a number from 1e-18 to 1e18, or its negative"},
    {TEXT(VIEW "s 1 2 3 -0.0\n"),
     "8: radius: found \"-0.0\", expected a number from 1e-18 to 1e18, or its negative"},
    {TEXT(VIEW "s 1 2 3 1e-60\n"),
     "8: radius: found \"1e-60\", expected a number from 1e-18 to 1e18, or its negative"},
    {TEXT(VIEW "s nan 2 3 4\n"), "8: x: found \"nan\", expected a number from -1e18 to 1e18"},
    {TEXT(VIEW "s 1 -inf 3 4\n"), "8: y: found \"-inf\", expected a number from -1e18 to 1e18"},
    {TEXT(VIEW "s 1 2 1e39 4\n"), "8: z: found \"1e39\", expected a number from -1e18 to 1e18"},
    {TEXT(VIEW "s -1.1e18 2 3 4\n"),
     "8: x: found \"-1.1e18\", expected a number from -1e18 to 1e18"},
    {TEXT(VIEW "s 1 2 3 -1.1e18\n"),
     "8: radius: found \"-1.1e18\", expected a number from 1e-18 to 1e18, or its negative"},
    {TEXT("v\nfrom 1 2e18 3\n"), "2: y: found \"2e18\", expected a number from -1e18 to 1e18"},
    {TEXT(VIEW "s 1 2 0x10 4\n"), "8: z: found \"0x10\", expected a number from -1e18 to 1e18"},
    {TEXT(VIEW "s 1 2 3,5 4\n"), "8: z: found \"3,5\", expected a number from -1e18 to 1e18"},
    {TEXT(VIEW "s 1 2 3 nan\n"),
     "8: radius: found \"nan\", expected a number from 1e-18 to 1e18, or its negative"},
    {TEXT(VIEW "s 1 2 3 -inf\n"),
     "8: radius: found \"-inf\", expected a number from 1e-18 to 1e18, or its negative"},
    {TEXT(VIEW "s 1 2 1.#QNAN 4\n"),
     "8: found \"1.#QNAN\", expected a blank before a comment's #, and no other #"},
    {TEXT(VIEW "s 1 2 3 1.#INF\n"),
     "8: found \"1.#INF\", expected a blank before a comment's #, and no other #"},
    {TEXT(VIEW SPHERE "s 0 0 0 1# glued\n"),
     "9: found \"1#\", expected a blank before a comment's #, and no other #"},
    {TEXT(VIEW "p 3\n0 0 0 1 0 0 0 1 0# glued\n"),
     "9: found \"0#\", expected a blank before a comment's #, and no other #"},
    {TEXT(VIEW "s 1 2 3 4abc\n"),
     "8: radius: found \"4abc\", expected a number from 1e-18 to 1e18, or its negative"},
    {TEXT(VIEW "s 1 2 3 \033[31m4\n"),
     "8: radius: found \"\\x1B[31m4\", expected a number from 1e-18 to 1e18, or its negative"},
    {TEXT(VIEW "s 1 2 3 \xFF\n"),
     "8: radius: found \"\\xFF\", expected a number from 1e-18 to 1e18, or its negative"},
    {TEXT(VIEW "s 1 2 3 11111111111111111111111111111111111111111111111111\n"),
     "8: radius: found \"1111111111111111111111111111111111111111...\", expected a "
     "number from 1e-18 to 1e18, or its negative"},
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
    {TEXT("v\nfrom 0 0 0\nat 0 2e38 0\nup 0 0 1\nangle 45\nresolution 2 2\nhither 1\n"),
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
    {TEXT("\xFF\xFEv\0\n\0"), "1: found text in UTF-16, expected ASCII or UTF-8: save it as such"},
    {TEXT("\xFE\xFF\0v\0\n"), "1: found text in UTF-16, expected ASCII or UTF-8: save it as such"},
    {TEXT("v\0\n\0"), "1: found a NUL byte, expected text"},
    {TEXT("\x89PNG\r\n\x1a\n"), "1: found \"\\x89PNG\", expected b, v, l, f, s, c, p, pp or #"},
};

Test(nff_faults, bad_text_gives_one_message_with_its_line)
{
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        expect_fault(scene3d_read_nff, BAD[i].text, BAD[i].length, BAD[i].message);
    }
}

Test(nff_faults, a_line_ends_somewhere)
{
    static char text[2 * LINE_MAX_LENGTH];
    memset(text, ' ', sizeof text);
    memcpy(text, VIEW, sizeof VIEW - 1);
    const size_t start = sizeof VIEW - 1;
    text[start] = '#';
    for (int is_too_long = 0; is_too_long < 2; is_too_long++) {
        Scene3D scene;
        capture_begin(2);
        int result = read_text(scene3d_read_nff, text,
                               start + LINE_MAX_LENGTH + (size_t)is_too_long, &scene);
        cr_expect_str_eq(capture_end(2), is_too_long ? "scene.nff:8: found more than 4096 "
                                                       "characters, expected a shorter line\n"
                                                     : "");
        cr_expect_eq(result, -is_too_long);
        scene3d_free(&scene);
    }
}

Test(nff_faults, lights_have_a_limit)
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

Test(nff_faults, a_folder_cannot_be_read)
{
    FILE *folder = fopen(".", "rb");
    cr_assert_not_null(folder);
    Scene3D scene = {0};
    cr_expect_eq(WITH_MESSAGE(strerror(EISDIR), scene3d_read_nff(folder, "folder.nff", &scene)),
                 -1);
    fclose(folder);
}

// That a file says how long it is, is no reason to believe it.
Test(nff_faults, a_count_is_not_believed)
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

// Wherever a download stops: a scene, or one message.
Test(nff_faults, cut_anywhere)
{
    static const char text[] =
        "# comment\r\nb 0.1 0.2 0.3\r\n" VIEW "l 1 2 3\nl 1 2 3 0.5 0.5 0.5\n"
        "f 1 0.5 0.25 1 0 10 0 1\ns 1 2 3 -4.5\np 3\n0 0 0\n1 0 0\n0 1 0\n"
        "c\n0 0 0 1\n0 0 1 0\npp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n"
        "0 1 0 0 0 1\ns 4 5 6 7e-1\n";
    cr_expect_gt(expect_cut_anywhere(scene3d_read_nff, text), 10);
}
