// common/scene2d_csv: scenes as text, whatever the text may hold.
#include "random.h"
#include "scene2d.h"
#include "surroundings.h"

#include <locale.h>
#include <math.h>

TestSuite(csv, .init = folder_enter, .fini = folder_leave);

#define HEADER "x,y,radius,depth,r,g,b\n"

// Text with its length, so that it may hold NUL bytes.
#define TEXT(literal) literal, sizeof(literal) - 1

static int read_text(const char *text, size_t length, Scene2D *scene)
{
    *scene = (Scene2D){0};
    FILE *file = tmpfile();
    fwrite(text, 1, length, file);
    rewind(file);
    int result = scene2d_read_csv(file, "scene.csv", scene);
    fclose(file);
    return result;
}

static void expect_circle(const Circle *circle, Circle expected)
{
    cr_expect_eq(memcmp(circle, &expected, sizeof expected), 0, "read (%g %g %g %g %g %g %g %g)",
                 (double)circle->x, (double)circle->y, (double)circle->radius,
                 (double)circle->depth, (double)circle->r, (double)circle->g, (double)circle->b,
                 (double)circle->a);
}

// ---- Good text ----------------------------------------------------------------------------------

static const struct {
    const char *text;
    size_t length;
    int n_circles;  // the first is always (1, -2.5, 3, 0.5), colour (0, 0.25, 1, 1)
} GOOD[] = {
    {TEXT(HEADER), 0},
    {TEXT("x,y,radius,depth,r,g,b"), 0},
    {TEXT(HEADER "1,-2.5,3,0.5,0,0.25,1\n"), 1},
    {TEXT(HEADER "1,-2.5,3,0.5,0,0.25,1"), 1},
    {TEXT(HEADER "1,-2.5,3,0.5,0,0.25,1\n4,4,4,4,1,1,1\n"), 2},
    {TEXT("b,g,r,depth,radius,y,x\n1,0.25,0,0.5,3,-2.5,1\n"), 1},
    {TEXT("x,y,radius,depth,r,g,b,a\n1,-2.5,3,0.5,0,0.25,1,1\n"), 1},
    {TEXT("x,y,radius,depth,r,g,b\r\n1,-2.5,3,0.5,0,0.25,1\r\n"), 1},
    {TEXT("\xEF\xBB\xBFx,y,radius,depth,r,g,b\n1,-2.5,3,0.5,0,0.25,1\n"), 1},
    {TEXT("# by hand\n" HEADER "# one\n\n1,-2.5,3,0.5,0,0.25,1\n   \n"), 1},
    {TEXT("\"x\",\"y\",radius,depth,r,g,b\n\"1\",-2.5,\"3\",0.5,0,0.25,1\n"), 1},
    {TEXT(" x , y ,radius,depth,r,g,b\n 1,\t-2.5 , 3,0.5,0,0.25,1 \n"), 1},
    {TEXT(HEADER "1e0,-25E-1,+3.,.5,0,0.25,1e-0\n"), 1},
};

Test(csv, good_text_is_read)
{
    for (size_t i = 0; i < sizeof GOOD / sizeof GOOD[0]; i++) {
        Scene2D scene;
        cr_assert_eq(read_text(GOOD[i].text, GOOD[i].length, &scene), 0, "case %zu", i);
        cr_expect_eq(scene.n_circles, GOOD[i].n_circles, "case %zu", i);
        if (scene.n_circles > 0) {
            expect_circle(&scene.circles[0], (Circle){1, -2.5f, 3, 0.5f, 0, 0.25f, 1, 1});
        }
        scene2d_free(&scene);
    }
}

// A library may have set a language with a decimal comma. "de_DE" need not be installed; then the
// test says nothing, and that is all it can do.
Test(csv, the_locale_plays_no_part)
{
    if (setlocale(LC_ALL, "de_DE.UTF-8") == NULL) {
        SKIP_TEST("no locale with a decimal comma is installed");
    }
    Scene2D scene;
    cr_assert_eq(read_text(GOOD[2].text, GOOD[2].length, &scene), 0);
    expect_circle(&scene.circles[0], (Circle){1, -2.5f, 3, 0.5f, 0, 0.25f, 1, 1});
    scene2d_free(&scene);
}

// ---- Bad text -----------------------------------------------------------------------------------

#define LINE "1,1,1,1,1,1,1\n"

static const struct {
    const char *text;
    size_t length;
    const char *message;
} BAD[] = {
    {TEXT(""), "scene.csv:1: "},
    {TEXT("\n\n"), "scene.csv:3: found the end of the file"},
    {TEXT("# only a comment\n"), "scene.csv:2: found the end"},
    {TEXT("x,y,radius,depth,r,g\n"), "scene.csv:1: found no column \"b\""},
    {TEXT("x,y,radius,depth,r,g,b,colour\n"), "found \"colour\""},
    {TEXT("x,y,radius,depth,r,g,b,x\n"), "found \"x\", expected each column once"},
    {TEXT("x,y,radius,depth,r,g,b,a,a\n"), "each column once"},
    {TEXT("X,y,radius,depth,r,g,b\n"), "found \"X\""},
    {TEXT("1,1,1,1,1,1,1\n"), "names of columns"},
    {TEXT(HEADER "1,1,1,1,1,1\n"), "scene.csv:2: found 6 fields, expected 7"},
    {TEXT(HEADER LINE LINE "1,1,1"), "scene.csv:4: found 3 fields"},
    {TEXT(HEADER LINE "1,1,1,1,1,1,1,1\n"), "scene.csv:3: found more fields"},
    {TEXT(HEADER "# comment\n\n1,1,abc,1,1,1,1\n"), "scene.csv:4: radius: found \"abc\""},
    {TEXT(HEADER "1,,1,1,1,1,1\n"), "y: found \"\""},
    {TEXT(HEADER "1,1x,1,1,1,1,1\n"), "y: found \"1x\""},
    {TEXT(HEADER "1,1 1,1,1,1,1,1\n"), "y: found \"1 1\""},
    {TEXT(HEADER "1,0x10,1,1,1,1,1\n"), "y: found \"0x10\""},
    {TEXT(HEADER "1,1.2.3,1,1,1,1,1\n"), "y: found"},
    {TEXT(HEADER "nan,1,1,1,1,1,1\n"), "x: found \"nan\", expected a finite number"},
    {TEXT(HEADER "inf,1,1,1,1,1,1\n"), "x: found \"inf\""},
    {TEXT(HEADER "1,1,1,-Infinity,1,1,1\n"), "depth: found"},
    {TEXT(HEADER "1e999,1,1,1,1,1,1\n"), "x: found \"1e999\", expected a finite number"},
    {TEXT(HEADER "1,1,-0.5,1,1,1,1\n"), "radius: found \"-0.5\", expected a number from 0 to 1e18"},
    {TEXT(HEADER "1,1,2e18,1,1,1,1\n"), "radius: found \"2e18\", expected a number from 0 to 1e18"},
    {TEXT(HEADER "1,-2e18,1,1,1,1,1\n"),
     "y: found \"-2e18\", expected a number from -1e18 to 1e18"},
    {TEXT(HEADER "1,1,1,1,1.01,1,1\n"), "r: found \"1.01\", expected a number from 0 to 1"},
    {TEXT(HEADER "1,1,1,1,1,1,-1\n"), "b: found \"-1\""},
    {TEXT(HEADER "1,1,1,1,1,1,\0011\n"), "b: found \"\\x011\""},
    {TEXT(HEADER "1,1,1\0,1,1,1,1\n"), "scene.csv:2: found a NUL byte"},
    {TEXT("\0\0\0"), "scene.csv:1: found a NUL byte"},
    {TEXT("\x89PNG\r\n\x1a\n"), "scene.csv:1: found \"\\x89PNG\""},
    {TEXT(HEADER "\"1,1,1,1,1,1,1\n" LINE LINE), "scene.csv:2: found a quote"},
    {TEXT(HEADER "1,1\"1\",1,1,1,1,1\n"), "scene.csv:2: found a quote"},
    {TEXT(HEADER "1;1;1;1;1;1;1\n"), "x: found \"1;1;1;1;1;1;1\""},
};

Test(csv, bad_text_gives_one_message_with_its_line)
{
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        Scene2D scene;
        cr_expect_eq(WITH_MESSAGE(BAD[i].message, read_text(BAD[i].text, BAD[i].length, &scene)),
                     -1, "case %zu was read: %s", i, BAD[i].message);
        cr_expect_null(scene.circles);
    }
}

Test(csv, endless_lines_and_quotes_are_bounded)
{
    static char text[1 << 20];
    memset(text, '1', sizeof text);
    memcpy(text, HEADER, sizeof HEADER - 1);
    for (int quoted = 0; quoted < 2; quoted++) {
        if (quoted) {
            text[sizeof HEADER - 1] = '"';
        }
        Scene2D scene;
        capture_begin(2);
        int result = read_text(text, sizeof text, &scene);
        const char *message = capture_end(2);
        expect_one_message(message, "scene.csv:2: ");
        cr_expect_lt(strlen(message), 200);
        cr_expect_eq(result, -1);
    }
}

Test(csv, a_last_line_without_its_end_is_warned_of)
{
    static const char *const ENDS[][2] = {
        {"",
         "scene.csv: warning: the last line (2) has no line end: if the file was cut there, its "
         "last number is wrong\n"},
        {" ", ""},
        {"\r", ""},
        {"\n", ""},
    };
    for (size_t i = 0; i < sizeof ENDS / sizeof ENDS[0]; i++) {
        char text[128];
        Scene2D scene = {0};
        snprintf(text, sizeof text, HEADER "1,2,3,0.5,1,1,0.25%s", ENDS[i][0]);
        capture_begin(2);
        int result = read_text(text, strlen(text), &scene);
        cr_expect_str_eq(capture_end(2), ENDS[i][1]);
        cr_assert_eq(result, 0);
        cr_expect(scene.n_circles == 1 && scene.circles[0].b == 0.25f);
        scene2d_free(&scene);
    }
}

// ---- Every float --------------------------------------------------------------------------------

// Write the circles as text, read it, and expect the same bits. Nine digits bring every float back.
static void expect_to_read_back(const Circle *circles, int n_circles)
{
    FILE *file = tmpfile();
    fputs("x,y,radius,depth,r,g,b,a\n", file);
    for (int i = 0; i < n_circles; i++) {
        const Circle *c = &circles[i];
        fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", (double)c->x, (double)c->y,
                (double)c->radius, (double)c->depth, (double)c->r, (double)c->g, (double)c->b,
                (double)c->a);
    }
    rewind(file);
    Scene2D again = {0};
    cr_assert_eq(scene2d_read_csv(file, "scene.csv", &again), 0);
    fclose(file);
    cr_assert_eq(again.n_circles, n_circles);
    cr_expect_eq(memcmp(again.circles, circles, (size_t)n_circles * sizeof *circles), 0);
    scene2d_free(&again);
}

Test(csv, nine_digits_read_back_to_the_same_floats)
{
    const Circle circles[] = {
        {1.0f / 3, -1e-30f, 1e18f, 3.4e38f, 0.1f, 1.0f / 255, 1, 0.5f},
        {123456.789f, -1e18f, 16777217, -1e30f, 0, 0.99999994f, 1e-45f, 0},
    };
    expect_to_read_back(circles, 2);
}

// Any bits that make a finite float.
Test(csv, every_float_reads_back)
{
    Random random = {1};
    static Circle circles[20000];
    const int n_circles = (int)(sizeof circles / sizeof circles[0]);
    for (int i = 0; i < n_circles; i++) {
        uint32_t bits = (uint32_t)random_bits(&random);
        memcpy(&circles[i].depth, &bits, sizeof bits);
        if (!isfinite(circles[i].depth)) {
            circles[i].depth = 0;
        }
    }
    expect_to_read_back(circles, n_circles);
}

// Which float a decimal is, says the compiler; halfway between two it is the even one.
Test(csv, a_decimal_becomes_the_nearest_float)
{
#define DECIMAL(number) {#number, number##f}
    static const struct {
        const char *text;
        float expected;
    } DECIMALS[] = {
        DECIMAL(0.1),
        DECIMAL(16777217.0),
        DECIMAL(16777219.0),
        DECIMAL(16777217.0000001),
        DECIMAL(1.000000059604644775390625),
        DECIMAL(1.000000059604644775390626),
        DECIMAL(3.40282356e38),
        DECIMAL(1.17549435e-38),
        DECIMAL(1.4e-45),
        DECIMAL(2.0e-45),
    };
#undef DECIMAL
    for (size_t i = 0; i < sizeof DECIMALS / sizeof DECIMALS[0]; i++) {
        char text[128];
        Scene2D scene;
        snprintf(text, sizeof text, HEADER "0,0,0,%s,0,0,0\n", DECIMALS[i].text);
        cr_assert_eq(read_text(text, strlen(text), &scene), 0, "%s", DECIMALS[i].text);
        cr_expect_eq(scene.circles[0].depth, DECIMALS[i].expected, "%s", DECIMALS[i].text);
        scene2d_free(&scene);
    }
}

// ---- Files --------------------------------------------------------------------------------------

Test(csv, a_file_opened_by_name_takes_the_size_that_was_asked_for)
{
    file_write("two.csv", TEXT(HEADER LINE LINE));
    Scene2D scene;
    cr_assert_eq(scene2d_open("two.csv", 30, 20, &scene), 0);
    cr_expect(scene.n_circles == 2 && scene.width == 30 && scene.height == 20);
    scene2d_free(&scene);
}

Test(csv, a_million_lines_take_seconds)
{
    FILE *file = tmpfile();
    fputs(HEADER, file);
    for (int i = 0; i < 1000000; i++) {
        fprintf(file, "%d.0625,12.5,3.25,0.5,0.25,0.5,1\n", i % 1000);
    }
    rewind(file);
    Scene2D scene = {0};
    cr_assert_eq(scene2d_read_csv(file, "scene.csv", &scene), 0);
    fclose(file);
    cr_expect_eq(scene.n_circles, 1000000);
    scene2d_free(&scene);
}
