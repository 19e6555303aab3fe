// Words of messages (see words.h).
#include "words.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

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

Words words_float(float value)
{
    Words text = words("%g", value);
    for (int digits = 7; digits <= 9 && strtof(text.text, NULL) != value; digits++) {
        text = words("%.*g", digits, value);
    }
    return text;
}

Words words_rgba(u32 color)
{
    return words("red %u green %u blue %u alpha %u", color & 255, color >> 8 & 255,
                 color >> 16 & 255, color >> 24);
}

Words words_circle(Circle circle)
{
    return words("(%s, %s) radius %s", words_float(circle.x).text, words_float(circle.y).text,
                 words_float(circle.radius).text);
}

Words words_sphere(Sphere sphere)
{
    return words("(%s, %s, %s) radius %s", words_float(sphere.x).text, words_float(sphere.y).text,
                 words_float(sphere.z).text, words_float(sphere.radius).text);
}

Words words_box2d(BBox2D box)
{
    return words("x [%s, %s] y [%s, %s]", words_float(box.minX).text, words_float(box.maxX).text,
                 words_float(box.minY).text, words_float(box.maxY).text);
}

Words words_box3d(BBox3D box)
{
    return words("x [%s, %s] y [%s, %s] z [%s, %s]", words_float(box.min[0]).text,
                 words_float(box.max[0]).text, words_float(box.min[1]).text,
                 words_float(box.max[1]).text, words_float(box.min[2]).text,
                 words_float(box.max[2]).text);
}
