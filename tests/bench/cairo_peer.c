// Cairo on the same circles (see peers2d.h).
#include "peers2d.h"

#ifdef WITH_CAIRO

#include "complain.h"

#include <cairo.h>
#include <math.h>
#include <string.h>

const char *cairo_peer_version(void)
{
    return cairo_version_string();
}

static double channel(u32 color, int i)
{
    return (color >> (8 * i) & 0xff) / 255.0;
}

int cairo_peer_draw(Circles circles, int width, int height, u32 *pixels)
{
    memset(pixels, 0, (size_t)width * (size_t)height * sizeof *pixels);
    cairo_surface_t *surface = cairo_image_surface_create_for_data(
        (unsigned char *)pixels, CAIRO_FORMAT_ARGB32, width, height, width * (int)sizeof *pixels);
    cairo_t *cairo = cairo_create(surface);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
    // Its samples are the pixels' middles, ours their corners.
    cairo_translate(cairo, 0.5, 0.5);
    for (u32 i = circles.n_circles; i-- > 0;) {
        const TileCircle circle = circles.circles[i];
        // Blue for red, as in its pixels red is the third byte.
        cairo_set_source_rgba(cairo, channel(circle.color, 2), channel(circle.color, 1),
                              channel(circle.color, 0), channel(circle.color, 3));
        cairo_arc(cairo, circle.x, circle.y, sqrt(circle.radius_squared), 0, 2 * M_PI);
        cairo_fill(cairo);
    }
    const cairo_status_t status = cairo_status(cairo);
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    cairo_surface_destroy(surface);
    if (status != CAIRO_STATUS_SUCCESS) {
        complain("cairo: %s", cairo_status_to_string(status));
        return -1;
    }
    return 0;
}

#else

#include <stddef.h>

const char *cairo_peer_version(void)
{
    return NULL;
}

int cairo_peer_draw(Circles circles, int width, int height, u32 *pixels)
{
    (void)circles, (void)width, (void)height, (void)pixels;
    return -1;
}

#endif
