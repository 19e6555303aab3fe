// Figures that can be touched: the course's own code, compiled to WebAssembly, in a page of the
// notes.
//
// A figure is a state (where the pixel or the ray is) and a number of steps. The page hands on what
// the reader does, and shows the drawing and the words that come back; it computes nothing. Read
// next: touch.c, then touch.js.
#ifndef TOUCH_H
#define TOUCH_H

#include "figures.h"

enum { STEP_STAYS = -1 };

typedef struct TouchFigure {
    const char *name;  // of the still figure in whose place it stands: "03-search"
    const char *what;  // what it is and what the arrow keys do, for those who cannot see it
    // Set the scene up, and the state of the still figure. Returns 0, or -1 after a message.
    int (*open)(void);
    // The reader drags to a point of the drawing; or presses arrow keys: this many to the right and
    // down. With `other` set, Shift is held: it moves the figure's second handle, where it has one.
    // Both return the step to show then, or STEP_STAYS.
    int (*drag)(double x, double y);
    int (*move)(int right, int down, int other);
    // The pointer goes down at a point: which handle does it take? NULL where there is only one.
    void (*take)(double x, double y);
    u32 (*count_steps)(void);
    u32 (*still_step)(void);  // which the still figure shows
    // Draw a step; say it in words, a line or a few.
    void (*draw)(FILE *file, u32 step, FigureShape shape);
    void (*tell)(FILE *file, u32 step);
} TouchFigure;

extern const TouchFigure TOUCH_SEARCH;  // 03-search
extern const TouchFigure TOUCH_RAY;     // 07-search
extern const TouchFigure TOUCH_COST;    // 08-cost

#endif
