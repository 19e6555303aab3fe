// mutant: squares are subtracted: the digits are gone
// task: cone_misses_sphere
// caught by: cone-hair
// says: digits are lost
    const float along = dot(centre, cone.axis);
    const float aside = sqrt(fmax(0.0f, dot(centre, centre) - along * along));
    const float outside = aside * cone.cosine - along * cone.sine;
    return outside > fabs(radius);
