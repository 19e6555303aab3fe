// mutant: squares are subtracted: the digits are gone
// task: cone_misses_sphere
// caught by: cone-hair
// says: found
    const float along = dot(centre, cone.axis);
    const float aside = sqrt(fmax(0.0f, (dot(centre, centre) - along * along) * 1.01f));
    return aside * cone.cosine - along * cone.sine > fabs(radius);
