// A scanline painter (see peers2d.h): what one would write without a tree, and for a scene that
// stands still hard to beat. A row of a circle is one span, and filling it is all the work.
//
// Bands of rows are shared out among threads; compiled for this machine and in vectors, as OpenCL
// compiles the kernels.
#include "peers2d.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>

// Rows that a thread takes at once: few enough for the threads to end together, and not so few that
// passing over all circles shows.
enum { ROWS_AT_ONCE = 64, MAX_THREADS = 256 };

// What the threads of one frame share.
typedef struct Frame {
    Circles circles;
    int width, height;
    u32 *pixels;
    atomic_int next_row;
} Frame;

// Does the circle hold the pixel in this column? As overlaps_N_Nearer() of lab 01 asks.
static int holds(TileCircle circle, float dy, int column)
{
    const float dx = (float)column - circle.x;
    return dx * dx + dy * dy <= circle.radius_squared;
}

// Fill the circle's span in one row. The root gives its ends but for rounding, and the kernels'
// comparison decides.
static void fill_span(TileCircle circle, float dy, int width, u32 *row)
{
    const float half = sqrtf(circle.radius_squared - dy * dy);
    int first = (int)ceilf(circle.x - half), last = (int)floorf(circle.x + half);
    while (holds(circle, dy, first - 1)) {
        first--;
    }
    while (first <= last && !holds(circle, dy, first)) {
        first++;
    }
    while (holds(circle, dy, last + 1)) {
        last++;
    }
    while (first <= last && !holds(circle, dy, last)) {
        last--;
    }
    first = first > 0 ? first : 0;
    last = last < width - 1 ? last : width - 1;
    for (int x = first; x <= last; x++) {
        row[x] = circle.color;
    }
}

// Paint what of the circles lies in the rows from first up to, but without, end.
static void paint_band(const Frame *frame, int first, int end)
{
    for (int i = first * frame->width; i < end * frame->width; i++) {
        frame->pixels[i] = 0;
    }
    for (u32 i = frame->circles.n_circles; i-- > 0;) {
        const TileCircle circle = frame->circles.circles[i];
        const float radius = sqrtf(circle.radius_squared);
        // A row more on both sides, as the root is rounded.
        const int top = (int)ceilf(circle.y - radius) - 1;
        const int bottom = (int)floorf(circle.y + radius) + 1;
        for (int y = top > first ? top : first; y <= bottom && y < end; y++) {
            const float dy = (float)y - circle.y;
            if (dy * dy <= circle.radius_squared) {
                fill_span(circle, dy, frame->width,
                          frame->pixels + (size_t)y * (size_t)frame->width);
            }
        }
    }
}

static void *paint_bands(void *shared)
{
    Frame *frame = shared;
    for (;;) {
        const int first = atomic_fetch_add(&frame->next_row, ROWS_AT_ONCE);
        if (first >= frame->height) {
            return NULL;
        }
        const int end = first + ROWS_AT_ONCE;
        paint_band(frame, first, end < frame->height ? end : frame->height);
    }
}

void painter_draw(Circles circles, int width, int height, int n_threads, u32 *pixels)
{
    Frame frame = {.circles = circles, .width = width, .height = height, .pixels = pixels};
    pthread_t threads[MAX_THREADS];
    int n_started = 0;
    // This thread paints, too.
    while (n_started < n_threads - 1 && n_started < MAX_THREADS &&
           pthread_create(&threads[n_started], NULL, paint_bands, &frame) == 0) {
        n_started++;
    }
    paint_bands(&frame);
    for (int i = 0; i < n_started; i++) {
        pthread_join(threads[i], NULL);
    }
}
