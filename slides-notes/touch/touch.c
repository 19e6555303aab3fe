// What the page calls (see touch.h): one figure at a time, and text that comes back.
//
// Strings are handed over as addresses in the program's memory, zero at their end. Read next: touch.js.
#include "touch.h"

#include <stdlib.h>

#define EXPORT(name) __attribute__((export_name(#name)))

static const TouchFigure *const FIGURES[] = {&TOUCH_SEARCH, &TOUCH_RAY, &TOUCH_COST};
enum { N_FIGURES = sizeof FIGURES / sizeof *FIGURES };

static const TouchFigure *figure;

// The name of figure `i` and what it is; NULL behind the last one.
EXPORT(touch_name) const char *touch_name(int i)
{
    return i < N_FIGURES ? FIGURES[i]->name : NULL;
}

EXPORT(touch_what) const char *touch_what(int i)
{
    return i < N_FIGURES ? FIGURES[i]->what : NULL;
}

// Choose figure `i`, before all that follows. Returns 0, or -1 after a message.
EXPORT(touch_open) int touch_open(int i)
{
    figure = FIGURES[i];
    return figure->open();
}

EXPORT(touch_take) void touch_take(double x, double y)
{
    if (figure->take != NULL) {
        figure->take(x, y);
    }
}

EXPORT(touch_drag) int touch_drag(double x, double y)
{
    return figure->drag(x, y);
}

EXPORT(touch_move) int touch_move(int right, int down, int other)
{
    return figure->move(right, down, other);
}

EXPORT(touch_count_steps) u32 touch_count_steps(void)
{
    return figure->count_steps();
}

EXPORT(touch_still_step) u32 touch_still_step(void)
{
    return figure->still_step();
}

// ---- Text ---------------------------------------------------------------------------------------

// What was written last; the next text takes its place.
static char *text;

static FILE *text_begin(void)
{
    static size_t n_bytes;
    free(text);
    FILE *file = open_memstream(&text, &n_bytes);
    if (file == NULL) {
        abort();
    }
    return file;
}

EXPORT(touch_draw) const char *touch_draw(u32 step, int is_narrow)
{
    FILE *file = text_begin();
    figure->draw(file, step, is_narrow ? SHAPE_NARROW : SHAPE_WIDE);
    fclose(file);
    return text;
}

EXPORT(touch_tell) const char *touch_tell(u32 step)
{
    FILE *file = text_begin();
    figure->tell(file, step);
    fclose(file);
    return text;
}
