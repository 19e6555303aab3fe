// Brute force in double precision: every ray asks every sphere, in the order of the array.
//
// How far may a right solution in float be off? With u = 2^-24, the rounding of one float
// operation:
//
// 1. The ray. pixel_on_display() costs a division (2.5 ulp = 5 u, OpenCL 1.2, 7.4) and a handful of
//    roundings of numbers up to the display's half width; the view transform three products and two
//    sums; normalize() a few ulp more, for which OpenCL 1.2 gives no bound: about 25 u altogether.
//    RAY_ERROR is 32 u, across the ray and along it.
// 2. The sphere's centre seen from the eye, c, is exact within u |c|, b = c . d within 4 u |c|, and
//    l = c - b d within 2 u |c| more. With the ray's error the line is displaced at the sphere by
//        e = (direction_error + ROOT_ERROR) |c|,   ROOT_ERROR = 12 u
//    so l lies between |l| - e and |l| + e, the middle of the chord b between b - e and b + e.
// 3. r² - l . l costs 5 u (r² + l²), its root 3 ulp = 6 u. From the largest and the smallest l
//    come the longest and the shortest half chord, and so an interval for either root: a hit is
//    certain when even the shortest is there, impossible when not even the longest is. The
//    textbook's form has no l: its discriminant is the difference of two numbers of the size of
//    c . c, off by TEXTBOOK_ERROR |c|² besides.
// 4. A ray is ambiguous unless its nearest hit is certain and its interval ends before every other
//    one begins. Its t is off by no more than the interval says.
//
// Colours, 5, are in oracle3d_colors.c.
//
// 6. A ray that leaves a surface (oracle3d_mirrors.c) starts at a point that is off by
//    origin_error, and the line by as much at every sphere. Of the sphere that it leaves, a right
//    solution does not find the point where it starts. With b = c . d and |c| = r the other root is
//    at 2 b, ahead when b > 0: from inside. Off by e, b makes that 2 e, and |c| as much as r e / b.
//
// 7. Of two spheres around one centre a right solution finds the same c, b and l, however far these
//    are off, and so which is entered first: their discs differ by the difference of the squares of
//    their radii. What may hide that is each one's own rounding, 10 u r² of the disc, 6 u of its
//    root and u of the entry.
#include "oracle3d.h"
#include "oracle3d_rounding.h"

#define RAY_ERROR (32 * ROUNDING)       // see 1
#define ROOT_ERROR (12 * ROUNDING)      // see 2
#define TEXTBOOK_ERROR (24 * ROUNDING)  // see 3: o . o, (o . d)² and d's own length, 8 u each

// ---- Rays -------------------------------------------------------------------------------------

void oracle3d_axes(const View *view, OracleVector axes[3])
{
    const OracleVector forward =
        vector_unit(vector_minus(vector_of(view->at), vector_of(view->from)));
    // Up is what is left of view.up when its share along forward is taken away.
    const OracleVector view_up = vector_unit(vector_of(view->up));
    const OracleVector up =
        vector_unit(vector_minus(view_up, vector_scaled(vector_dot(view_up, forward), forward)));
    axes[0] = vector_cross(forward, up);
    axes[1] = up;
    axes[2] = forward;
}

OracleVector oracle3d_display(int x, int y, int width, int height, double fov,
                              const OracleRules3D *rules)
{
    const double fov_width = rules->fov_is_half_width ? 2 * fov
                             : rules->fov_is_angle    ? 2 * tan(fov / 2)
                                                      : fov;
    const double pixel_width = fov_width / (rules->fov_is_height ? height : width);
    const double pixel_height = rules->fov_both_ways ? fov_width / height : pixel_width;
    return (OracleVector){(x + 0.5 + rules->sample_offset - width / 2.0) * pixel_width,
                          (height / 2.0 - y - 0.5 - rules->sample_offset) * pixel_height, 1};
}

OracleRay oracle3d_primary_ray(const Camera *camera, int x, int y, int width, int height,
                               const OracleRules3D *rules)
{
    const OracleVector p = oracle3d_display(x, y, width, height, camera->fov, rules);
    const OracleVector right = vector_of(camera->right), up = vector_of(camera->up),
                       forward = vector_of(camera->forward);
    const OracleVector direction =
        rules->axes_transposed
            ? (OracleVector){vector_dot(p, right), vector_dot(p, up), vector_dot(p, forward)}
            : vector_plus(vector_plus(vector_scaled(p.x, right), vector_scaled(p.y, up)),
                          vector_scaled(p.z, forward));
    return (OracleRay){.origin = vector_of(camera->eye),
                       .direction = rules->not_normalised ? direction : vector_unit(direction),
                       .direction_error = RAY_ERROR};
}

OracleRay oracle3d_given_ray(Vec3 origin, Vec3 direction, float t_min)
{
    // In float a unit vector is as long as 1 within the rounding of three components.
    return (OracleRay){.origin = vector_of(origin),
                       .direction = vector_unit(vector_of(direction)),
                       .t_min = t_min,
                       .direction_error = 2 * ROUNDING};
}

// ---- One sphere -------------------------------------------------------------------------------

// One of the two roots: where it is, NAN when nowhere, and where float may find it.
typedef struct Root {
    double t, low, high;
} Root;

// Take a root for the hit where it is, or may be, beyond the limit. Returns 1 when it is for
// certain, so that the other root no longer matters.
static int may_hit(OracleRoot *hit, Root root, double limit)
{
    if (root.high <= limit) {
        return 0;
    }
    hit->t = hit->t == INFINITY && root.t > limit ? root.t : hit->t;
    hit->t_low = hit->is_possible ? fmin(hit->t_low, root.low) : root.low;
    hit->t_high = hit->is_possible ? fmax(hit->t_high, root.high) : root.high;
    hit->is_possible = 1;
    hit->is_certain = root.low > limit;
    return hit->is_certain;
}

OracleChord oracle3d_chord(Sphere sphere, const OracleRay *ray, OracleForm form)
{
    const OracleVector c = vector_minus(centre_of(sphere), ray->origin);
    const double r2 = (double)sphere.radius * sphere.radius, c2 = vector_dot(c, c);
    const double b = vector_dot(c, ray->direction);
    const OracleVector across = vector_minus(c, vector_scaled(b, ray->direction));
    const double l2 = vector_dot(across, across);
    const double e = (ray->direction_error + ROOT_ERROR) * sqrt(c2) + ray->origin_error;
    OracleChord chord = {.middle = b, .error = e, .half = NAN};
    // A clear miss takes no root: (r + e)² is at most 2 (r² + e²).
    if (l2 > 4 * (r2 + e * e + TEXTBOOK_ERROR * c2)) {
        return chord;
    }
    // 3: the shortest and the longest half chord, squared.
    const double l = sqrt(l2), l_low = fmax(l - e, 0);
    const double rounding = 5 * ROUNDING * (r2 + (l + e) * (l + e)) +
                            (form == ORACLE_TEXTBOOK ? TEXTBOOK_ERROR * c2 : 0);
    const double shortest2 = r2 - (l + e) * (l + e) - rounding;
    const double longest2 = r2 - l_low * l_low + rounding;
    chord.is_possible = longest2 >= 0;
    chord.is_certain = shortest2 >= 0;
    chord.shortest = sqrt(fmax(shortest2, 0)) * (1 - 6 * ROUNDING);
    chord.longest = sqrt(fmax(longest2, 0)) * (1 + 6 * ROUNDING);
    chord.half = l2 <= r2 ? sqrt(r2 - l2) : NAN;
    return chord;
}

static int is_copy(const Sphere *a, const Sphere *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z && a->radius == b->radius;
}

// 6: of the sphere that the ray leaves, or a copy of it, the root at its start is none.
static OracleRoot root_of_left(Sphere sphere, const OracleRay *ray)
{
    const OracleChord chord = oracle3d_chord(sphere, ray, ORACLE_PROJECTION);
    const double b = chord.middle, e = chord.error;
    OracleRoot root = {.t = b > 0 ? 2 * b : INFINITY, .is_possible = b > -e, .is_certain = b > e};
    if (root.is_possible) {
        const double off = 2 * e + (b > 0 ? fabs((double)sphere.radius) * e / b : 0);
        root.t_low = 2 * b - off;
        root.t_high = 2 * b + off;
    }
    return root;
}

OracleRoot oracle3d_root(Sphere sphere, const OracleRay *ray, OracleForm form,
                         const OracleRules3D *rules)
{
    if (ray->leaves != NULL && is_copy(&sphere, ray->leaves)) {
        return root_of_left(sphere, ray);
    }
    const OracleChord chord = oracle3d_chord(sphere, ray, form);
    OracleRoot root = {.t = INFINITY};
    if (!chord.is_possible || (rules->negative_radius_missed && sphere.radius < 0)) {
        return root;
    }
    const double b = chord.middle, shortest = chord.shortest, longest = chord.longest;
    // Of b, and of the last operation.
    const double last = chord.error + ROUNDING * (fabs(b) + longest);
    const Root t_near = {b - chord.half, b - longest - last, b - shortest + last};
    const Root t_far = {b + chord.half, b + shortest - last, b + longest + last};

    const double limit = rules->any_distance ? -INFINITY : ray->t_min;
    const int has_near_side =
        (sphere.radius > 0 || rules->radius_sign_ignored) && !rules->farther_root;
    const int enters = has_near_side && may_hit(&root, t_near, limit);
    if (!enters && !rules->inside_is_miss) {
        may_hit(&root, t_far, limit);
    }
    root.is_certain &= chord.is_certain;
    return root;
}

// ---- The nearest ------------------------------------------------------------------------------

// 7: does the ray enter the one sphere and then, certainly in float too, the other, around the same
// centre?
static int is_shell_before(const Sphere *first, const Sphere *second, const OracleRay *ray)
{
    if (first->x != second->x || first->y != second->y || first->z != second->z ||
        first->radius < second->radius || second->radius <= 0 || ray->leaves != NULL) {
        return 0;
    }
    const OracleChord outer = oracle3d_chord(*first, ray, ORACLE_PROJECTION);
    const OracleChord inner = oracle3d_chord(*second, ray, ORACLE_PROJECTION);
    const double last = outer.error + ROUNDING * (fabs(outer.middle) + outer.longest);
    if (!inner.is_certain || outer.middle - outer.longest - last <= ray->t_min) {
        return 0;
    }
    const double r2 = (double)first->radius * first->radius;
    const double discs = r2 - (double)second->radius * second->radius - 20 * ROUNDING * r2;
    const double rounding = 2 * ROUNDING * (6 * outer.longest + fabs(outer.middle) + outer.longest);
    return discs / (2 * outer.longest) > rounding;
}

// Does the hit at t take the ray from the one found so far?
static int takes_ray(double t, const OracleHit *found, const OracleRules3D *rules)
{
    if (t == INFINITY) {
        return 0;
    }
    if (found->sphere == ORACLE_NO_SPHERE) {
        return 1;
    }
    if (rules->first_wins || rules->last_wins) {
        return rules->last_wins;
    }
    if (rules->farthest_wins) {
        return t > found->t;
    }
    return rules->later_wins_ties ? t <= found->t : t < found->t;
}

OracleHit oracle3d_nearest(const Sphere *spheres, u32 n_spheres, const OracleRay *ray,
                           const OracleRules3D *rules)
{
    OracleHit hit = {.sphere = ORACLE_NO_SPHERE, .t = INFINITY};
    OracleRoot root = {0};         // of the hit
    double others_low = INFINITY;  // where the first interval of any other sphere begins
    u32 other = ORACLE_NO_SPHERE;  // and whose it is
    const u32 first = rules->skip_first ? 1 : 0;
    const u32 end = n_spheres + (rules->one_sphere_more ? 1 : 0);
    for (u32 i = first; i + (rules->skip_last ? 1 : 0) < end; i++) {
        const OracleRoot own = oracle3d_root(spheres[i], ray, ORACLE_PROJECTION, rules);
        const int takes = takes_ray(own.t, &hit, rules);
        // What is not, or is no longer, the hit is one of the others.
        const OracleRoot *loser = takes ? &root : &own;
        const u32 loser_id = takes ? hit.sphere : i;
        const Sphere *winner = &spheres[takes ? i : hit.sphere];
        const int is_rival =
            loser->is_possible && loser_id != ORACLE_NO_SPHERE &&
            (hit.sphere == ORACLE_NO_SPHERE || !(is_copy(winner, &spheres[loser_id]) ||
                                                 is_shell_before(winner, &spheres[loser_id], ray)));
        if (is_rival && loser->t_low < others_low) {
            others_low = loser->t_low;
            other = loser_id;
        }
        if (takes) {
            hit.sphere = i;
            hit.t = own.t;
            root = own;
        }
    }
    if (hit.sphere == ORACLE_NO_SPHERE) {
        hit.is_ambiguous = other != ORACLE_NO_SPHERE;
    } else {
        hit.t_tolerance = fmax(root.t_high - hit.t, hit.t - root.t_low);
        const int is_by_distance = !(rules->first_wins || rules->last_wins || rules->farthest_wins);
        hit.is_ambiguous = !root.is_certain || (is_by_distance && others_low <= root.t_high);
    }
    return hit;
}
