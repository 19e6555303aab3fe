// The steps of a followed pixel in words, in lines as narrow as the panel.
//
// Read next: record.h of common/follow.
#ifndef VIEW_PANEL_LINES_H
#define VIEW_PANEL_LINES_H

#include "record.h"

// The steps in words: "leaf 213: t 2.10 to 2.35, 2 wait". The last line says how the pixel ended.
//   lines[PANEL_MAX_LINES]   out
// Returns how many there are.
enum { PANEL_LINE_LENGTH = 40, PANEL_MAX_LINES = MAX_STEPS + 1 };
typedef struct PanelLine {
    char text[96];
    int lists_missed;  // does it list elements that were asked in vain? The next such one joins it
} PanelLine;
int panel_lines(const World *world, const Steps *steps, PanelLine *lines);

#endif
