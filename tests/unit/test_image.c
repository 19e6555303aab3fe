// common/image: files that keep every float, pictures for people, and a comparison that nothing
// wrong passes.
#include "image.h"
#include "random.h"
#include "surroundings.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <sys/resource.h>

TestSuite(image, .init = folder_enter, .fini = folder_leave);

static Image image_new(int width, int height)
{
    Image image;
    cr_assert_eq(image_create(width, height, &image), 0);
    return image;
}

static size_t n_values(const Image *image)
{
    return (size_t)image->width * (size_t)image->height * IMAGE_CHANNELS;
}

// ---- In memory ----------------------------------------------------------------------------------

Test(image, is_made_black_and_transparent)
{
    Image image = image_new(5, 3);
    cr_expect(image.width == 5 && image.height == 3);
    for (size_t i = 0; i < n_values(&image); i++) {
        cr_expect_eq(image.pixels[i], 0.0f);
    }
    image_free(&image);
    cr_expect_null(image.pixels);
    image_free(&image);
}

Test(image, sizes_that_are_none)
{
    static const int SIZES[][2] = {{0, 4}, {4, 0}, {-1, 4}, {4, -1}};
    for (size_t i = 0; i < sizeof SIZES / sizeof SIZES[0]; i++) {
        Image image;
        cr_expect_eq(WITH_MESSAGE("positive", image_create(SIZES[i][0], SIZES[i][1], &image)), -1);
        cr_expect_null(image.pixels);
    }
}

Test(image, more_pixels_than_memory)
{
#ifdef __SANITIZE_ADDRESS__
    SKIP_TEST("the address sanitizer ends the program where calloc() would return NULL");
#endif
    Image image;
    cr_expect_eq(WITH_MESSAGE("no memory", image_create(INT_MAX, INT_MAX, &image)), -1);
}

// ---- Files --------------------------------------------------------------------------------------

Test(image, exr_brings_back_every_bit)
{
    Image image = image_new(7, 3);
    for (size_t i = 0; i < n_values(&image); i++) {
        image.pixels[i] = (float)i / 7 - 3;
    }
    image.pixels[0] = NAN;
    image.pixels[1] = -INFINITY;
    image.pixels[2] = FLT_MAX;
    image.pixels[5] = FLT_TRUE_MIN;
    image.pixels[6] = -0.0f;
    image.pixels[9] = 1e-30f;
    cr_assert_eq(image_save(&image, "a.exr"), 0);
    cr_expect_eq(folder_count(), 1, "a partial file stayed behind");

    Image loaded;
    cr_assert_eq(image_load("a.exr", &loaded), 0);
    cr_assert(loaded.width == 7 && loaded.height == 3);
    cr_expect_eq(memcmp(image.pixels, loaded.pixels, n_values(&image) * sizeof(float)), 0);
    image_free(&image);
    image_free(&loaded);
}

Test(image, png_is_clamped_and_opaque)
{
    static const struct {
        float value;
        float expected;
    } VALUES[] = {{-1, 0}, {0, 0}, {0.3f, 76.0f / 255}, {0.5f, 128.0f / 255},
                  {1, 1},  {7, 1}, {INFINITY, 1},       {-INFINITY, 0},
                  {NAN, 0}};
    const int n = (int)(sizeof VALUES / sizeof VALUES[0]);
    Image image = image_new(n, 1);
    for (int i = 0; i < n; i++) {
        image.pixels[i * IMAGE_CHANNELS + 1] = VALUES[i].value;
    }
    cr_assert_eq(image_save(&image, "a.png"), 0);

    Image loaded;
    cr_assert_eq(image_load("a.png", &loaded), 0);
    for (int i = 0; i < n; i++) {
        const float *pixel = loaded.pixels + i * IMAGE_CHANNELS;
        cr_expect_float_eq(pixel[1], VALUES[i].expected, 1e-6, "%g became %g",
                           (double)VALUES[i].value, (double)pixel[1]);
        cr_expect_eq(pixel[0], 0.0f);
        cr_expect_eq(pixel[3], 1.0f);
    }
    image_free(&image);
    image_free(&loaded);
}

Test(image, row_0_is_on_top)
{
    Image image = image_new(1, 2);
    image.pixels[0] = 1;
    cr_assert_eq(image_save(&image, "a.png"), 0);
    Image loaded;
    cr_assert_eq(image_load("a.png", &loaded), 0);
    cr_expect_eq(loaded.pixels[0], 1.0f);
    cr_expect_eq(loaded.pixels[IMAGE_CHANNELS], 0.0f);
    image_free(&image);
    image_free(&loaded);
}

// A PGM holds one grey channel and no alpha.
Test(image, grey_is_spread_and_missing_alpha_is_1)
{
    file_write("grey.pgm", "P5\n2 1\n255\n\x00\xff", 13);
    Image image;
    cr_assert_eq(image_load("grey.pgm", &image), 0);
    static const float EXPECTED[] = {0, 0, 0, 1, 1, 1, 1, 1};
    cr_expect_arr_eq(image.pixels, EXPECTED, sizeof EXPECTED);
    image_free(&image);
}

Test(image, what_cannot_be_saved_leaves_nothing)
{
    static const struct {
        const char *path;
        const char *message;
    } BAD[] = {
        {"picture.jpg", ".exr or .png"},  {"picture", ".exr or .png"},
        {".png", ".exr or .png"},         {"folder/.png", ".exr or .png"},
        {"folder.png/a", ".exr or .png"}, {"nowhere/a.png", "nowhere"},
        {"nowhere/a.exr", "nowhere"},     {"folder.png", "regular"},
    };
    mkdir("folder.png", 0777);
    Image image = image_new(2, 2);
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        cr_expect_eq(WITH_MESSAGE(BAD[i].message, image_save(&image, BAD[i].path)), -1,
                     "%s was saved", BAD[i].path);
    }
    cr_expect_eq(folder_count(), 1);
    image_free(&image);
}

Test(image, the_stem_is_what_stands_before_the_ending)
{
    static const struct {
        const char *path;
        size_t length;
    } PATHS[] = {
        {"a.png", 1}, {"a.exr", 1}, {"b.c/a.png", 5}, {"a.b.png", 3}, {".a.png", 2}, {"", 0},
        {"a.jpg", 0}, {".png", 0},  {"b/.exr", 0},    {"a.png/b", 0}, {"a.PNG", 0},  {"png", 0},
    };
    for (size_t i = 0; i < sizeof PATHS / sizeof PATHS[0]; i++) {
        cr_expect_eq(image_stem_length(PATHS[i].path), PATHS[i].length, "%s", PATHS[i].path);
    }
}

// A limit on the file's size stands for a full disk.
Test(image, a_full_disk_leaves_nothing_behind)
{
    Image image = image_new(64, 64);
    Random random = {1};  // noise, so that compressing does not make it fit
    for (size_t i = 0; i < n_values(&image); i++) {
        image.pixels[i] = (float)random_integer(&random, 0, 1 << 20) / (1 << 20);
    }
    signal(SIGXFSZ, SIG_IGN);
    struct rlimit usual, limit;
    getrlimit(RLIMIT_FSIZE, &usual);
    limit = usual;
    limit.rlim_cur = 4096;

    static const char *const PATHS[] = {"a.exr", "a.png"};
    for (size_t i = 0; i < sizeof PATHS / sizeof PATHS[0]; i++) {
        char expected[64];
        snprintf(expected, sizeof expected, "%s: cannot be written: File too large", PATHS[i]);
        capture_begin(2);
        setrlimit(RLIMIT_FSIZE, &limit);
        int result = image_save(&image, PATHS[i]);
        setrlimit(RLIMIT_FSIZE, &usual);
        expect_one_message(capture_end(2), expected);
        cr_expect_eq(result, -1);
        cr_expect_eq(folder_count(), 0);
    }
    image_free(&image);
}

Test(image, what_cannot_be_loaded)
{
    mkdir("folder.png", 0777);
    file_write("empty.png", "", 0);
    file_write("garbage.exr", "This is no picture.", 19);
    Image whole = image_new(64, 64);
    cr_assert_eq(image_save(&whole, "cut.exr"), 0);
    cr_assert_eq(truncate("cut.exr", 400), 0);
    image_free(&whole);
    static const char *const BAD[] = {"missing.png", "folder.png", "empty.png", "garbage.exr",
                                      "cut.exr"};
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        Image image;
        cr_expect_eq(WITH_MESSAGE(BAD[i], image_load(BAD[i], &image)), -1, "%s was loaded", BAD[i]);
        cr_expect_null(image.pixels);
    }
}

// Nobody writes to the pipe; what waits for a writer is ended by the alarm.
Test(image, a_pipe_is_not_waited_for)
{
    cr_assert_eq(mkfifo("pipe.png", 0600), 0);
    cr_assert_eq(symlink("pipe.png", "link.png"), 0);
    static const char *const PATHS[] = {"pipe.png", "link.png", "/dev/null"};
    alarm(60);
    for (size_t i = 0; i < sizeof PATHS / sizeof PATHS[0]; i++) {
        Image image;
        cr_expect_eq(WITH_MESSAGE(": cannot be read: found a pipe or a device, expected a "
                                  "regular file",
                                  image_load(PATHS[i], &image)),
                     -1);
        cr_expect_null(image.pixels);
    }
}

// ---- Comparison ---------------------------------------------------------------------------------

Test(image, equal_pictures_do_not_differ)
{
    Image image = image_new(4, 4);
    image.pixels[10] = 0.5f;
    ImageDifference result = image_compare(&image, &image, 0);
    cr_expect(result.same_size && result.n_different == 0 && result.n_not_finite == 0);
    cr_expect(result.first_x == -1 && result.first_y == -1 && result.max_difference == 0);
    image_free(&image);
}

Test(image, a_smaller_picture_never_passes)
{
    Image image = image_new(4, 4);
    Image narrow = image_new(3, 4);
    Image low = image_new(4, 3);
    Image turned = image_new(2, 8);
    cr_expect_not(image_compare(&narrow, &image, 1).same_size);
    cr_expect_not(image_compare(&low, &image, 1).same_size);
    cr_expect_not(image_compare(&turned, &image, 1).same_size);
    image_free(&image);
    image_free(&narrow);
    image_free(&low);
    image_free(&turned);
}

Test(image, what_is_not_finite_never_passes)
{
    static const float BAD[] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < 3; i++) {
        Image image = image_new(4, 4);
        Image reference = image_new(4, 4);
        image.pixels[(2 * 4 + 1) * IMAGE_CHANNELS + 3] = BAD[i];
        ImageDifference in_image = image_compare(&image, &reference, INFINITY);
        ImageDifference in_reference = image_compare(&reference, &image, INFINITY);
        ImageDifference in_both = image_compare(&image, &image, INFINITY);
        cr_expect(in_image.n_not_finite == 1 && in_image.n_different == 1);
        cr_expect(in_reference.n_not_finite == 1 && in_reference.n_different == 1);
        cr_expect(in_both.n_not_finite == 1 && in_both.n_different == 1);
        cr_expect(in_image.first_x == 1 && in_image.first_y == 2);
        cr_expect_eq(in_image.max_difference, 0.0f);
        image_free(&image);
        image_free(&reference);
    }
}

Test(image, a_picture_of_nans_never_passes)
{
    Image image = image_new(4, 4);
    Image reference = image_new(4, 4);
    for (size_t i = 0; i < n_values(&image); i++) {
        image.pixels[i] = NAN;
    }
    ImageDifference result = image_compare(&image, &reference, 1);
    cr_expect(result.n_not_finite == 16 && result.n_different == 16);
    image_free(&image);
    image_free(&reference);
}

Test(image, differences_are_counted_beyond_the_tolerance)
{
    Image image = image_new(4, 4);
    Image reference = image_new(4, 4);
    image.pixels[(1 * 4 + 3) * IMAGE_CHANNELS + 0] = 0.25f;
    image.pixels[(1 * 4 + 3) * IMAGE_CHANNELS + 2] = -0.75f;  // the same pixel counts once
    image.pixels[(3 * 4 + 0) * IMAGE_CHANNELS + 1] = 0.5f;
    ImageDifference strict = image_compare(&image, &reference, 0);
    cr_expect(strict.n_different == 2 && strict.first_x == 3 && strict.first_y == 1);
    cr_expect_eq(strict.max_difference, 0.75f);
    ImageDifference at_limit = image_compare(&image, &reference, 0.5f);
    cr_expect_eq(at_limit.n_different, 1, "a difference equal to the tolerance is within it");
    cr_expect_eq(image_compare(&image, &reference, 0.75f).n_different, 0);
    image_free(&image);
    image_free(&reference);
}

Test(image, the_difference_picture_is_black_where_equal_and_bright_where_not)
{
    Image image = image_new(4, 1);
    Image reference = image_new(4, 1);
    image.pixels[1 * IMAGE_CHANNELS] = 0.25f;
    image.pixels[2 * IMAGE_CHANNELS] = INFINITY;
    image.pixels[3 * IMAGE_CHANNELS] = NAN;
    Image difference;
    cr_assert_eq(image_difference_picture(&image, &reference, &difference), 0);
    float brightness[4];
    for (int x = 0; x < 4; x++) {
        const float *pixel = difference.pixels + x * IMAGE_CHANNELS;
        brightness[x] = pixel[0] + pixel[1] + pixel[2];
        cr_expect_eq(pixel[3], 1.0f);
    }
    cr_expect_eq(brightness[0], 0.0f);
    cr_expect_gt(brightness[1], 0.5f);
    cr_expect_gt(brightness[2], brightness[1]);
    // Cyan, which is none of the colours of differences.
    const float *nan_pixel = difference.pixels + 3 * IMAGE_CHANNELS;
    cr_expect(nan_pixel[0] == 0 && nan_pixel[1] == 1 && nan_pixel[2] == 1);
    image_free(&difference);

    Image other = image_new(2, 1);
    cr_expect_eq(
        WITH_MESSAGE("expected the same", image_difference_picture(&image, &other, &difference)),
        -1);
    image_free(&image);
    image_free(&reference);
    image_free(&other);
}
