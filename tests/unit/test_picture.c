// judge/picture: only the right picture passes, and what is wrong in another is said.
#include "picture_case.h"

#include <math.h>

TestSuite(picture);

// ---- Right and wrong ----------------------------------------------------------------------------

static void expect_right(const Case *c)
{
    cr_expect(picture_is_right(c->probe, &c->expected));
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_expect_null(message, "%s", message);
    free(message);
}

static void expect_wrong(const Case *c, const char *expected)
{
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_expect(message != NULL && strcmp(message, expected) == 0, "found \"%s\", expected \"%s\"",
              message ? message : "(right)", expected);
    free(message);
}

// Nobody wrote n pixels, this one the first of them.
static void expect_unwritten(const Case *c, int x, int y, int n)
{
    const float *pixel = reference_pixel(c, x, y);
    char expected[256];
    snprintf(expected, sizeof expected,
             "nobody wrote pixel (%d, %d) of a %dx%d picture: found nothing, expected (%.4g, %.4g, "
             "%.4g, %.4g) (%d of 6144 pixels were not written)",
             x, y, c->width, c->height, (double)pixel[0], (double)pixel[1], (double)pixel[2],
             (double)pixel[3], n);
    expect_wrong(c, expected);
}

Test(picture, an_equal_picture_is_right)
{
    Case *c = case_open(96, 64, 1);
    expect_right(c);
    expected_picture_recognise(&c->expected, NULL, NULL);
    expect_right(c);
    case_close(c);
    c = case_open(64, 96, 2);
    expect_right(c);
    case_close(c);
}

Test(picture, one_pixel_is_named_with_both_values)
{
    Case *c = case_open(96, 64, 1);
    memcpy(c->expected.reference.pixels + (63 * 96 + 95) * IMAGE_CHANNELS,
           (float[]){0.25f, 0.5f, 0.125f, 1}, 4 * sizeof(float));
    own_show(c, &c->expected.reference);
    own_pixel(c, 95, 63)[1] = 0.75f;
    expect_wrong(c, "pixel (95, 63): found (0.25, 0.75, 0.125, 1), expected (0.25, 0.5, 0.125, 1) "
                    "(1 of 6144 pixels differ)");
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        own_show(c, &c->expected.reference);
        own_pixel(c, 3, 2)[channel] = nextafterf(own_pixel(c, 3, 2)[channel], 2);
        char *message = told(picture_judge(c->probe, &c->expected));
        cr_expect(message != NULL && strstr(message, "pixel (3, 2): ") == message);
        free(message);
    }
    // The first in reading order is named, and all are counted.
    own_show(c, &c->expected.reference);
    own_pixel(c, 9, 8)[0] += 1, own_pixel(c, 8, 9)[0] += 1;
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_expect(message != NULL && strstr(message, "pixel (9, 8): ") == message &&
                  strstr(message, " (2 of 6144 pixels differ)") != NULL,
              "%s", message);
    free(message);
    case_close(c);
}

Test(picture, what_is_not_finite_never_passes)
{
    static const struct {
        float value;
        const char *looks;
    } values[] = {{NAN, "not a number in places"},
                  {-NAN, "not a number in places"},
                  {INFINITY, "infinite in places"},
                  {-INFINITY, "infinite in places"}};
    Case *c = case_open(64, 96, 3);
    c->expected.tolerances = calloc(64 * 96, sizeof(float));
    for (int is_ambiguous = 0; is_ambiguous <= 1; is_ambiguous++) {
        for (int j = 0; j < 64 * 96; j++) {
            c->expected.tolerances[j] = is_ambiguous ? INFINITY : 0.5f;
        }
        for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
            for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
                own_show(c, &c->expected.reference);
                own_pixel(c, 5, 7)[channel] = values[i].value;
                cr_expect_str_eq(looks_of(c), values[i].looks);
            }
            own_show(c, &c->expected.reference);
            for (int j = 0; j < 64 * 96; j++) {
                float *pixel = own_pixel(c, j % 64, j / 64);
                pixel[0] = pixel[1] = pixel[2] = pixel[3] = values[i].value;
            }
            cr_expect_str_eq(looks_of(c), values[i].looks);
        }
    }
    case_close(c);
}

Test(picture, the_tolerance_is_the_last_that_passes)
{
    Case *c = case_open(96, 64, 1);
    c->expected.tolerance = 0.25f;
    float *expected = c->expected.reference.pixels + (3 * 96 + 2) * IMAGE_CHANNELS;
    expected[2] = 0.5f;
    for (int sign = -1; sign <= 1; sign += 2) {
        own_pixel(c, 2, 3)[2] = 0.5f + (float)sign * 0.25f;
        expect_right(c);
        own_pixel(c, 2, 3)[2] = 0.5f + (float)sign * 0.250001f;
        cr_expect_str_eq(looks_of(c), "");
    }
    case_close(c);
}

Test(picture, every_pixel_has_its_tolerance)
{
    Case *c = case_open(96, 64, 1);
    c->expected.tolerances = calloc(96 * 64, sizeof(float));
    c->expected.tolerances[3 * 96 + 2] = 0.25f;
    c->expected.tolerance = 1;  // it counts where there are no others
    own_pixel(c, 2, 3)[2] += 0.25f;
    expect_right(c);
    own_pixel(c, 3, 3)[2] += 0.125f;
    cr_expect_str_eq(looks_of(c), "");
    case_close(c);
}

Test(picture, only_ambiguous_pixels_may_differ)
{
    Case *c = case_open(64, 96, 3);
    c->expected.tolerances = calloc(64 * 96, sizeof(float));
    c->expected.tolerances[7 * 64 + 5] = INFINITY;
    own_pixel(c, 5, 7)[0] += 0.5f;
    expect_right(c);
    own_pixel(c, 7, 5)[0] += 0.5f;
    char *message = told(picture_judge(c->probe, &c->expected));
    cr_expect(message != NULL && strstr(message, "pixel (7, 5): ") == message &&
                  strstr(message, " (1 of 6144 pixels differ)") != NULL,
              "%s", message);
    free(message);
    // Either choice is a colour that somebody wrote.
    own_show(c, &c->expected.reference);
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        own_pixel(c, 5, 7)[channel] = UNWRITTEN;
    }
    expect_unwritten(c, 5, 7, 1);
    case_close(c);
}

Test(picture, unwritten_pixels_are_told_from_wrong_ones)
{
    Case *c = case_open(96, 64, 1);
    own_clear(c);
    expect_unwritten(c, 0, 0, 6144);
    own_show(c, &c->expected.reference);
    for (int y = 10; y < 13; y++) {
        for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
            own_pixel(c, 20, y)[channel] = UNWRITTEN;
        }
    }
    expect_unwritten(c, 20, 10, 3);
    own_pixel(c, 50, 50)[0] += 1;
    cr_expect_str_eq(looks_of(c), "");
    case_close(c);
}

// ---- Around the picture -------------------------------------------------------------------------

static void expect_message(Diagnosis diagnosis, const char *part)
{
    char *message = told(diagnosis);
    cr_expect(part ? message != NULL && strstr(message, part) != NULL : message == NULL,
              "found \"%s\", expected \"%s\"", message ? message : "(nothing)",
              part ? part : "(nothing)");
    free(message);
}

Test(picture, what_is_written_outside_is_found)
{
    // The image is 96 + 16 by 64 + 16 pixels.
    static const int places[][2] = {{96, 0}, {0, 64}, {96, 64}, {111, 79}, {111, 0}, {0, 79}};
    Case *c = case_open(96, 64, 1);
    cr_assert(c->probe.image_width == 112 && c->probe.image_height == 80);
    expect_message(picture_judge_padding(c->probe, &c->expected), NULL);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
            float *value = &own_pixel(c, places[i][0], places[i][1])[channel];
            char part[64];
            snprintf(part, sizeof part, "pixel (%d, %d) of a 96x64 picture", places[i][0],
                     places[i][1]);
            *value = channel % 2 ? NAN : 0;
            expect_message(picture_judge_padding(c->probe, &c->expected), part);
            expect_message(picture_judge_padding(c->probe, &c->expected),
                           "or a barrier comes behind it");
            *value = UNWRITTEN;
        }
    }
    expect_message(picture_judge_padding(c->probe, &c->expected), NULL);
    expect_right(c);
    case_close(c);
}

Test(picture, what_nobody_wrote_is_found)
{
    Case *c = case_open(64, 96, 1);
    expect_message(picture_judge_written(c->probe, &c->expected), NULL);
    own_pixel(c, 63, 95)[0] = UNWRITTEN;
    own_pixel(c, 9, 9)[3] = NAN;
    expect_message(picture_judge_written(c->probe, &c->expected), NULL);
    for (int channel = 0; channel < IMAGE_CHANNELS; channel++) {
        own_pixel(c, 63, 95)[channel] = own_pixel(c, 0, 95)[channel] = UNWRITTEN;
    }
    expect_message(picture_judge_written(c->probe, &c->expected),
                   "nobody wrote pixel (0, 95) of a 64x96 picture: found nothing, expected (0, 0, "
                   "0, 0) (2 of 6144");
    own_clear(c);
    expect_message(picture_judge_written(c->probe, &c->expected), "pixel (0, 0) of a 64x96");
    case_close(c);
}

Test(picture, is_copied_without_its_margin)
{
    Case *c = case_open(96, 64, 5);
    Image copy;
    cr_assert_eq(picture_copy(c->probe, 96, 64, &copy), 0);
    cr_expect(copy.width == 96 && copy.height == 64);
    const ImageDifference difference = image_compare(&copy, &c->expected.reference, 0);
    cr_expect(difference.same_size && difference.n_different == 0);
    image_free(&copy);
    case_close(c);
}
