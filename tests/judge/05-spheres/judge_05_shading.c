// Lab 05: surface_normal and shade on their inputs. See judge_05.h; judge_05_roots.c is a sibling.
#include "judge_05.h"

#include "message.h"
#include "oracle3d.h"
#include "oracle3d_rounding.h"
#include "words.h"

static const OracleRules3D right = {0};

// ---- surface_normal: right ----------------------------------------------------------------------

static OracleNear normal_of(const NormalJob *in)
{
    return oracle3d_normal(in->sphere, oracle3d_exactly(in->point), oracle3d_exactly(in->direction),
                           &right);
}

static OracleVector outwards(const NormalJob *in)
{
    return vector_minus(vector_of(in->point), centre_of(in->sphere));
}

static double along_ray(const NormalJob *in, OracleVector v)
{
    return vector_dot(v, vector_of(in->direction));
}

#define GIVEN                                                                                      \
    const NormalJob *in = &((const Job05 *)job)->normals[i];                                       \
    const Vec3 found = ((const Vec3 *)answers)[i]
#define IS_FOUND(vector) is_normal(in, vector, found)

// Where the dot product is 0, to the bit, the ray comes from neither side, and either is right.
static int is_normal(const NormalJob *in, OracleVector vector, Vec3 found)
{
    const OracleNear near = {vector, normal_of(in).error * fmax(1, vector_length(vector))};
    return oracle3d_is_near(found, near) ||
           (along_ray(in, outwards(in)) == 0 && oracle3d_is_near(vec3_scaled(found, -1), near));
}

RIGHT(is_right_normal, IS_FOUND(normal_of(in).value))

// ---- surface_normal: mistakes -------------------------------------------------------------------

static OracleVector turned(int is_turned, OracleVector v)
{
    return is_turned ? vector_scaled(-1, v) : v;
}

// Turned from a cosine on that is not 0, but less than all rolled ones, or than all but the least.
static OracleVector turned_beyond(const NormalJob *in, double cosine)
{
    const OracleVector outside = vector_unit(outwards(in));
    return turned(along_ray(in, outside) > cosine, outside);
}

#define TURNED_LATE "it must be turned where the dot product is positive, however small"
#define TURNED_EARLY "it must not be turned where the dot product is negative, however small"

KNOWN_LIST(known_normals)
{
    GIVEN;
    const OracleVector normal = normal_of(in).value;
    const OracleVector outside = vector_unit(outwards(in));
    const double distance = vector_length(outwards(in));
    const OracleVector from_origin = vector_unit(vector_of(in->point));

    ANSWERS(long_normal, vector_scaled(distance, normal), "it is not a unit vector");
    ANSWERS(long_outwards, outwards(in), "it is not a unit vector, and points away from the eye");
    ANSWERS(not_turned, outside, "seen from inside it must be turned, towards the eye");
    ANSWERS(inwards, turned(1, outside), "it points to the centre, not away from it");
    ANSWERS(turned_away, turned(1, normal), "it points away from where the ray comes from");

    ANSWERS(turned_late, turned_beyond(in, 0x1p-5), TURNED_LATE);
    ANSWERS(turned_early, turned_beyond(in, -0x1p-5), TURNED_EARLY);
    ANSWERS(late_by_hair, turned_beyond(in, 0x1p-30), TURNED_LATE);
    ANSWERS(early_by_hair, turned_beyond(in, -0x1p-30), TURNED_EARLY);

    ANSWERS(turned_by_radius, turned(in->sphere.radius < 0, outside),
            "the radius' sign turned it: the dot product with the direction decides");
    ANSWERS(turned_by_place, turned(along_ray(in, vector_of(in->point)) > 0, outside),
            "the point's place in the scene turned it: the normal's dot product decides");
    ANSWERS(by_radius, vector_scaled(distance / fabs(in->sphere.radius), normal),
            "it was divided by the radius: where float rounds the point, that is not how far the "
            "centre is, and the normal is no unit vector");
    ANSWERS(by_signed_radius, vector_scaled(1 / (double)in->sphere.radius, outwards(in)),
            "it was divided by the radius, whose sign turned it: the dot product with the "
            "direction decides, and float rounds the point");
    EACH(centre_forgotten,
         vec3_length(in->point) == 0 ||
             IS_FOUND(turned(along_ray(in, from_origin) > 0, from_origin)) ||
             (fabs(along_ray(in, from_origin)) < 0x1p-20 &&
              IS_FOUND(vector_scaled(-1, from_origin))),
         "it points from the scene's origin to the point: the centre was forgotten");
    ONLY(short_kept, IS_FOUND(vector_scaled(distance, normal)),
         "other normals are right, but a short vector must be made a unit vector, too");
    ONLY(vanishes, along_ray(in, outwards(in)) == 0 && vec3_length(found) == 0,
         "other normals are right, but where the ray is a tangent the dot product is 0, and the "
         "normal was multiplied by it");
    return NO_MORE;
}

static char *describe_normal(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new(
        "sphere at %s, point %s, direction %s: found %s, expected %s",
        words_sphere(in->sphere).text, words_vec3(in->point, 6).text,
        words_vec3(in->direction, 6).text, words_vec3(found, 5).text,
        words_xyz(normal_of(in).value.x, normal_of(in).value.y, normal_of(in).value.z, 5).text);
}

const Function normal_05 = {"normals", 2 * N_NORMALS, sizeof(Vec3),
                            KNOWING(is_right_normal, describe_normal, known_normals)};
#undef GIVEN
#undef IS_FOUND

// ---- shade: right -------------------------------------------------------------------------------

#define GIVEN                                                                                      \
    const ShadeJob in = ((const Job05 *)job)->shades[i];                                           \
    const Light *lights = ((const Job05 *)job)->lights + in.first_light;                           \
    const Vec3 found = ((const Vec3 *)answers)[i];                                                 \
    (void)lights
#define IS_FOUND(color) oracle3d_is_near(found, color)

static OracleNear shaded(ShadeJob in, const Light *lights)
{
    return oracle3d_shade(oracle3d_exactly(in.point), oracle3d_exactly(in.normal), &in.material,
                          lights, in.n_lights, &right);
}

RIGHT(is_right_shade, IS_FOUND(shaded(in, lights)))

// ---- shade: mistakes ----------------------------------------------------------------------------

// Of a negative cosine. What lights behind the surface would add is what they add from behind.
static OracleNear with_behind(ShadeJob in, const Light *lights, double factor)
{
    const OracleNear before = shaded(in, lights);
    in.normal = vec3_scaled(in.normal, -1);
    const OracleNear behind = shaded(in, lights);
    return (OracleNear){vector_plus(before.value, vector_scaled(factor, behind.value)),
                        before.error + behind.error};
}

static OracleNear not_below_0(OracleNear color)
{
    const OracleVector c = color.value;
    return (OracleNear){{fmax(c.x, 0), fmax(c.y, 0), fmax(c.z, 0)}, color.error};
}

static OracleNear turned_round(ShadeJob in, const Light *lights)
{
    in.normal = vec3_scaled(in.normal, -1);
    return shaded(in, lights);
}

// Without cosines: of all lights, or of those before the surface.
static OracleNear uncosined(ShadeJob in, const Light *lights, int of_all)
{
    OracleNear sum = {{0}, shaded(in, lights).error};
    for (int i = 0; i < in.n_lights; i++) {
        const double size =
            in.material.kd * vec3_length(in.material.color) * vec3_length(lights[i].color);
        if (of_all || vec3_dot(in.normal, vec3_minus(lights[i].position, in.point)) > 0) {
            const OracleVector share = {(double)in.material.color.x * lights[i].color.x,
                                        (double)in.material.color.y * lights[i].color.y,
                                        (double)in.material.color.z * lights[i].color.z};
            sum.value = vector_plus(sum.value, vector_scaled(in.material.kd, share));
            sum.error += (4 + in.n_lights) * ROUNDING * size;
        }
    }
    return sum;
}

// Of the number of lights.
static ShadeJob lit_by(ShadeJob in, int n_lights)
{
    in.n_lights = n_lights;
    return in;
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int n_before_one_behind(ShadeJob in, const Light *lights)
{
    int n = 0;
    while (n < in.n_lights && vec3_dot(in.normal, vec3_minus(lights[n].position, in.point)) > 0) {
        n++;
    }
    return n;
}

static OracleNear first_lights(ShadeJob in, const Light *lights, int n)
{
    return shaded(lit_by(in, least(in.n_lights, n)), lights);
}

#define FIRST_ONLY(n)                                                                              \
    ANSWERS(first_##n, first_lights(in, lights, n), "that is the first " #n " lights' share only")

// Of what is given.
static ShadeJob changed(ShadeJob in, Vec3 point, float kd, Vec3 color)
{
    in.point = point;
    in.material.kd = kd;
    in.material.color = color;
    return in;
}

static const Vec3 zero = {0, 0, 0}, white = {1, 1, 1};

// With other colours of the lights, number k of which is `light`, `way` from the point.
#define RELIT(name, new_color, sentence)                                                           \
    for (int k = 0; number == 0 && k < in.n_lights; k++) {                                         \
        const Light light = lights[k];                                                             \
        const float way = vec3_length(vec3_minus(light.position, in.point));                       \
        (void)way;                                                                                 \
        others[k] = (Light){light.position, new_color};                                            \
    }                                                                                              \
    ANSWERS(name, shaded(in, others), sentence)

// Every light with the colour, or the place, of one of them.
static OracleNear lit_alike(ShadeJob in, const Light *lights, int i, int is_place)
{
    Light others[N_LIGHTS];
    for (int k = 0; k < in.n_lights; k++) {
        others[k] = is_place ? (Light){lights[i].position, lights[k].color}
                             : (Light){lights[k].position, lights[i].color};
    }
    return shaded(in, others);
}

// Of the sum.
static OracleNear brightest(ShadeJob in, const Light *lights)
{
    OracleNear most = {{0}, 0};
    for (int i = 0; i < in.n_lights; i++) {
        const OracleNear share = shaded(lit_by(in, 1), lights + i);
        most.value =
            (OracleVector){fmax(most.value.x, share.value.x), fmax(most.value.y, share.value.y),
                           fmax(most.value.z, share.value.z)};
        most.error = fmax(most.error, share.error);
    }
    return most;
}

// Of a cosine that is raised to a power, and its error with it.
#define HIGHLIGHT_ERROR 0x1p-14

static OracleNear highlighted(ShadeJob in, const Light *lights)
{
    OracleNear sum = shaded(in, lights);
    for (int i = 0; i < in.n_lights; i++) {
        const OracleVector way =
            vector_unit(vector_minus(vector_of(lights[i].position), vector_of(in.point)));
        const double cosine = fmax(vector_dot(vector_of(in.normal), way), 0);
        const double phong = in.material.ks * pow(cosine, fmax(in.material.shine, 1));
        sum.value = vector_plus(sum.value, vector_scaled(phong, vector_of(lights[i].color)));
        sum.error += HIGHLIGHT_ERROR * in.material.ks;
    }
    return sum;
}

// Raised to a power, and how far that may be off.
static OracleNear bent(OracleNear color, double power)
{
    const double channels[3] = {color.value.x, color.value.y, color.value.z};
    double value[3], error = 0;
    for (int i = 0; i < 3; i++) {
        value[i] = pow(fmax(channels[i], 0), power);
        const double low = pow(fmax(channels[i] - color.error, 0), power);
        const double high = pow(fmax(channels[i] + color.error, 0), power);
        error = fmax(error, fmax(high - value[i], value[i] - low) + POW_ERROR * value[i]);
    }
    return (OracleNear){{value[0], value[1], value[2]}, error};
}

KNOWN_LIST(known_shades)
{
    GIVEN;
    const OracleNear right_shade = shaded(in, lights);
    const OracleVector sum = right_shade.value;
    Light others[N_LIGHTS];

    ANSWERS(not_clamped, with_behind(in, lights, -1),
            "a light behind the surface takes light away: a negative cosine counts as 0");
    ANSWERS(lit_behind, with_behind(in, lights, 1),
            "a light behind the surface lights it: a negative cosine counts as 0");
    ANSWERS(sum_clamped, not_below_0(with_behind(in, lights, -1)),
            "a light behind the surface takes light away: each negative cosine counts as 0, not "
            "only a negative sum");

    ANSWERS(way_turned, turned_round(in, lights),
            "the way leads from the light to the point: the light's position less the point is the "
            "way to it");

#define NO_COSINE "the cosine is missing: the share of each light is multiplied by it"
    ANSWERS(no_cosine, uncosined(in, lights, 1), NO_COSINE);
    ANSWERS(no_cosine_before, uncosined(in, lights, 0), NO_COSINE);

    ANSWERS(first_only, first_lights(in, lights, 1), "that is the first light's share only");
    FIRST_ONLY(4);
    FIRST_ONLY(8);
    FIRST_ONLY(16);
    FIRST_ONLY(32);
    FIRST_ONLY(64);
    FIRST_ONLY(128);
    FIRST_ONLY(256);
    ANSWERS(last_only,
            in.n_lights < 2 ? right_shade : shaded(lit_by(in, 1), lights + in.n_lights - 1),
            "that is the last light's share only");
    ANSWERS(one_more, shaded(lit_by(in, in.n_lights + 1), lights),
            "one light too many shines, the one behind the end of the array");
    ANSWERS(stops_behind, first_lights(in, lights, n_before_one_behind(in, lights)),
            "the first light behind the surface ended the loop: those after it shine, too");

    ANSWERS(from_origin, shaded(changed(in, zero, in.material.kd, in.material.color), lights),
            "the light's place was taken for the way to it: that begins at the point");
    ANSWERS(kd_missing, shaded(changed(in, in.point, 1, in.material.color), lights),
            "kd is missing");
    ANSWERS(color_missing, shaded(changed(in, in.point, in.material.kd, white), lights),
            "the material's colour is missing");

    RELIT(falling_and_long, vec3_scaled(light.color, 1 / way),
          "light does not fall with the distance here, and the cosine is that of a unit vector");
    RELIT(way_not_unit, vec3_scaled(light.color, way),
          "the way to the light is not made a unit vector");
    RELIT(falls, vec3_scaled(light.color, 1 / (way * way)),
          "the light falls with the square of the distance, and must not");
    RELIT(no_light_color, white, "the light's colour is missing");
    RELIT(light_red_only, ((Vec3){light.color.x, light.color.x, light.color.x}),
          "the light's red was taken for its whole colour");
    RELIT(light_cut_at_1,
          ((Vec3){fminf(light.color.x, 1), fminf(light.color.y, 1), fminf(light.color.z, 1)}),
          "each light was cut at 1, but a light may be brighter");
    RELIT(kd_each_time,
          vec3_scaled(light.color, powf(in.material.kd, (float)(in.n_lights - 1 - k))),
          "the sum so far is multiplied by kd with each light");

    ANY(color_of_one, 2, IS_FOUND(lit_alike(in, lights, way ? in.n_lights - 1 : 0, 0)),
        "every light has the colour of the same one");
    ANY(place_of_one, 2, IS_FOUND(lit_alike(in, lights, way ? in.n_lights - 1 : 0, 1)),
        "every light stands where the same one does");

    ANSWERS(brightest_only, brightest(in, lights),
            "that is the brightest light's share only: the colour is the sum");
    EACH(mean,
         in.n_lights == 0 ||
             IS_FOUND(((OracleNear){vector_scaled(1.0 / in.n_lights, sum), right_shade.error})),
         "the sum was divided by the number of lights");
    ANSWERS(cut_at_1,
            ((OracleNear){{fmin(sum.x, 1), fmin(sum.y, 1), fmin(sum.z, 1)}, right_shade.error}),
            "the sum was cut at 1, but many lights may be brighter");
    ANSWERS(highlight, highlighted(in, lights),
            "a highlight was added, with ks: Lambert's law has none");
    ANSWERS(swapped, ((OracleNear){{sum.z, sum.y, sum.x}, right_shade.error}),
            "that is right with red and blue swapped", MISTAKE_CHANNELS_SWAPPED);
    ANSWERS(encoded, bent(right_shade, 1 / 2.2),
            "that is right but for gamma: the colour was raised to 1 / 2.2, but it is linear here",
            MISTAKE_GAMMA);
    ANSWERS(decoded, bent(right_shade, 2.2),
            "that is right but for gamma: the colour was raised to 2.2, but it is linear here",
            MISTAKE_GAMMA);
    return NO_MORE;
}

static char *describe_shade(const void *job, int i, const void *answers)
{
    GIVEN;
    const OracleVector sum = shaded(in, lights).value;
    return message_new("point %s, normal %s, kd %g, %d light%s%s%s: found %s, expected %s",
                       words_vec3(in.point, 6).text, words_vec3(in.normal, 6).text, in.material.kd,
                       in.n_lights, plural((unsigned)in.n_lights),
                       in.n_lights > 0 ? ", the first at " : "",
                       in.n_lights > 0 ? words_vec3(lights[0].position, 6).text : "",
                       words_vec3(found, 5).text, words_xyz(sum.x, sum.y, sum.z, 5).text);
}

const Function shade_05 = {"shades", 3 * N_SHADES, sizeof(Vec3),
                           KNOWING(is_right_shade, describe_shade, known_shades)};
