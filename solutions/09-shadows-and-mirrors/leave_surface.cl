// Lab 09: where a new ray starts, so that it does not hit the surface that it leaves.
//
// Flow: scene -> buffers -> KERNEL -> image. Called by mirrors.cl.

// How far off a sphere the point of a hit may be, for each unit of the numbers that it was computed
// from: t, the radius and the point's coordinates. With u = 2^-24, the rounding of one float
// operation:
//
// 1. The centre is at most t + r away from the ray's origin. intersect_sphere() finds the line's
//    distance from it, l, within 12 u (t + r); r² - l . l costs 10 u r², which is 5 u r of the
//    radius, and its root 6 u r. That b is off by 4 u (t + r), and |d|² by 6 u, shifts the point
//    along the ray, off the sphere by no more than 10 u (t + r).
// 2. origin + t d rounds two times: 2 u (t + |point|).
// 3. The next ray tests the same sphere. From a height h above it the ray certainly misses when
//    2 r h is more than what intersect_sphere() may be off then, 54 u r²: h must be 27 u r.
//
// Together 24 u t + 60 u r + 2 u |point|, and |point| is less than twice the largest coordinate: no
// factor is above 64 u, which is 2^-18.
#define SURFACE_ERROR 0x1p-18f

// The place where rays start that leave a sphere: off it, on the normal's side.
//   point    on the sphere within rounding, scene units; the ray that found it went t to there
//   normal   unit vector, to the side where the new rays go
//   radius   of the sphere; may be negative
// Not farther off than needed: a sphere closer to the surface than that is invisible from there.
float3 leave_surface(float3 point, float3 normal, float t, float radius)
{
#ifdef ACNE  // --acne draws without, to see what fails
    return point;
#endif
    // TASK leave_surface: go along the normal, SURFACE_ERROR times the sum of t, of the radius'
    // size and of the largest of the point's coordinates.
    //> (void)normal, (void)t, (void)radius;
    //> return point;
    const float largest = fmax(fmax(fabs(point.x), fabs(point.y)), fabs(point.z));
    return point + SURFACE_ERROR * (t + fabs(radius) + largest) * normal;
    // END leave_surface
}
