// Deviations of rays to first order (see oracle3d_deviation.h).
//
// With d the direction and n the normal, of a ray that is off by (o', d') the hit moves by
//     p' = o' + t d' + t' d,   where n . p' = 0:   t' = -n . (o' + t d') / (n . d)
// on a mirror of curvature k the normal turns by n' = k p', and the mirrored direction by
//     d' - 2 ((d' . n + d . n') n + (d . n) n')
#include "oracle3d_deviation.h"

double deviations_of_origin(const Deviations *deviations)
{
    double sum = 0;
    for (int i = 0; i < deviations->n; i++) {
        sum += vector_length(deviations->each[i].origin);
    }
    return sum;
}

double deviations_of_direction(const Deviations *deviations)
{
    double sum = 0;
    for (int i = 0; i < deviations->n; i++) {
        sum += vector_length(deviations->each[i].direction);
    }
    return sum;
}

static const OracleVector axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

void deviations_add_direction(Deviations *deviations, double error)
{
    for (int i = 0; i < 3; i++) {
        deviations->each[deviations->n++] = (Deviation){.direction = vector_scaled(error, axes[i])};
    }
}

void deviations_add_origin(Deviations *deviations, double error)
{
    for (int i = 0; i < 3; i++) {
        deviations->each[deviations->n++] = (Deviation){.origin = vector_scaled(error, axes[i])};
    }
}

void deviations_add_along(Deviations *deviations, OracleVector error)
{
    deviations->each[deviations->n++] = (Deviation){.origin = error};
}

void deviations_hit(Deviations *deviations, OracleVector direction, OracleVector normal, double t)
{
    for (int i = 0; i < deviations->n; i++) {
        Deviation *own = &deviations->each[i];
        const OracleVector aside = vector_plus(own->origin, vector_scaled(t, own->direction));
        const double later = -vector_dot(normal, aside) / vector_dot(normal, direction);
        own->origin = vector_plus(aside, vector_scaled(later, direction));
    }
}

void deviations_mirror(Deviations *deviations, OracleVector direction, OracleVector normal,
                       double curvature)
{
    for (int i = 0; i < deviations->n; i++) {
        Deviation *own = &deviations->each[i];
        const OracleVector turned = vector_scaled(curvature, own->origin);
        const double along = vector_dot(own->direction, normal) + vector_dot(direction, turned);
        own->direction = vector_minus(
            own->direction, vector_plus(vector_scaled(2 * along, normal),
                                        vector_scaled(2 * vector_dot(direction, normal), turned)));
    }
}

void deviations_leave_along_normal(Deviations *deviations, double curvature)
{
    for (int i = 0; i < deviations->n; i++) {
        deviations->each[i].direction = vector_scaled(curvature, deviations->each[i].origin);
    }
}

void deviations_make_unit(Deviations *deviations, OracleVector direction)
{
    const double length = vector_length(direction);
    const OracleVector unit = vector_scaled(1 / length, direction);
    for (int i = 0; i < deviations->n; i++) {
        const OracleVector off = deviations->each[i].direction;
        const OracleVector across = vector_minus(off, vector_scaled(vector_dot(off, unit), unit));
        deviations->each[i].direction = vector_scaled(1 / length, across);
    }
}
