// A script of keys and mouse events, instead of a user's: for tests and demonstrations. Time stands
// still between its lines, so the same script gives the same pictures on every machine.
//
//     key W            press and release a key, by its name in SDL: "W", "Left", "PageUp", "="
//     down W, up W     only press it, or only release it
//     click X Y        press and release the left button
//     drag X Y X2 Y2   press it, move, release it; "right" behind it takes the right one
//     wheel N X Y      turn the wheel by N notches, inwards is positive
//     frames N         draw N frames, each 1/25 s after the one before
//     save FILE        save the window as the last frame has shown it, .png or .exr
//     # a comment
//
// Read next: view.c.
#ifndef VIEW_SCRIPT_H
#define VIEW_SCRIPT_H

#include "line_reader.h"

#include <SDL.h>

enum { SCRIPT_MAX_EVENTS = 3 };

typedef struct Script {
    LineReader reader;  // reader.file is NULL where there is no script
    SDL_Event events[SCRIPT_MAX_EVENTS];
    int n_events;  // of the line at hand, those that are still to come
    int n_frames;  // the same for frames
    char save[LINE_MAX_LENGTH + 1];
} Script;

typedef enum ScriptStep {
    SCRIPT_EVENT,  // *event is set
    SCRIPT_FRAME,  // draw a frame
    SCRIPT_SAVE,   // save the window to script->save
    SCRIPT_END,    // there is no more
    SCRIPT_BAD,    // one message was printed on stderr that names the line
} ScriptStep;

// Open a script. Returns 0, or -1 after one message on stderr. Close with script_close(), which
// accepts a zeroed Script.
int script_open(Script *script, const char *path);
void script_close(Script *script);

// What comes next.
ScriptStep script_next(Script *script, SDL_Event *event);

#endif
