// Words of messages (see words.h).
#include "words.h"

#include <stdarg.h>
#include <stdio.h>

Words words(const char *format, ...)
{
    Words words;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words.text, sizeof words.text, format, arguments);
    va_end(arguments);
    return words;
}

Words words_xyz(double x, double y, double z, int digits)
{
    return words("(%.*g, %.*g, %.*g)", digits, x, digits, y, digits, z);
}

Words words_vec3(Vec3 v, int digits)
{
    return words_xyz(v.x, v.y, v.z, digits);
}

Words words_circle(Circle circle)
{
    return words("(%.9g, %.9g) radius %.9g", circle.x, circle.y, circle.radius);
}

Words words_sphere(Sphere sphere)
{
    return words("(%g, %g, %g) radius %g", sphere.x, sphere.y, sphere.z, sphere.radius);
}

Words words_box2d(BBox2D box)
{
    return words("x [%g, %g] y [%g, %g]", box.minX, box.maxX, box.minY, box.maxY);
}

Words words_box3d(BBox3D box)
{
    return words("x [%g, %g] y [%g, %g] z [%g, %g]", box.min[0], box.max[0], box.min[1], box.max[1],
                 box.min[2], box.max[2]);
}
