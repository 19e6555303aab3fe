// What the window of a lab knows while it is open, and the parts that work on it: controls.c takes
// keys and the mouse, panel.c draws what stands beside the picture, view.c goes round and round.
//
// Read next: view.c.
#ifndef VIEW_VIEWER_H
#define VIEW_VIEWER_H

#include "frame.h"
#include "panel_lines.h"
#include "window.h"

// The panel stands to the right of the picture, so that it hides nothing of it. However small the
// picture is, all of the panel and of the help is seen.
enum { PANEL_WIDTH = 352, MIN_WIDTH = 520, MIN_HEIGHT = 640 };

// Levels of the tree that the slider offers.
enum { SHALLOWEST = 1, DEEPEST = 30 };

// A path is recorded and played, and a film made, at this number of poses a second.
enum { POSES_A_SECOND = 25 };

// What a pressed mouse button has hold of.
typedef enum Grip { GRIP_NONE, GRIP_SLIDER, GRIP_LOOK, GRIP_ORBIT } Grip;

typedef struct Viewer {
    World world;
    const WorldKernel *kernels;  // [n_kernels]
    int n_kernels;
    Frame frame;
    Image heat;
    Window window;

    // What the user has chosen.
    int kernel;  // which one draws
    int shows_heat, shows_help, orbits, ends;
    int plays, restarts_path;  // the path of --path
    int max_depth;             // of the tree that is wanted; 0: what is best
    unsigned keys_held;        // a bit for each key of flight (controls.c)
    Grip grip;
    int grip_x, grip_y;  // where the mouse was last while it had hold
    int has_dragged;     // it has moved since it was pressed
    Motion motion;       // what the mouse has asked for since the last frame
    const char *note;    // one line for the user: what went wrong; or NULL

    // The pixel that is followed.
    int is_following, pixel_x, pixel_y;
    int is_told;  // its steps stand on standard output, too
    Steps steps;
    PanelLine lines[PANEL_MAX_LINES];
    int n_lines, first_line;  // and which of them is the first that is shown

    // Is what is shown up to date?
    int is_placed, is_drawn, is_counted, is_followed, is_shown;

    // Measured.
    double frame_ms;    // from one frame to the next, while something moves
    double latency_ms;  // from a key to the frame that shows what it did
    double key_at_ms;   // stats_clock_ms() at that key, 0 where it is shown
} Viewer;

// The kernel that draws.
static inline const WorldKernel *viewer_kernel(const Viewer *viewer)
{
    return &viewer->kernels[viewer->kernel];
}

// The first kernel whose rays go on from what they hit; -1: the lab has none.
static inline int viewer_find_bouncing(const Viewer *viewer)
{
    for (int i = 0; i < viewer->n_kernels; i++) {
        if (viewer->kernels[i].has_bounces) {
            return i;
        }
    }
    return -1;
}

// How many levels the tree that is wanted may have.
static inline int viewer_depth(const Viewer *viewer)
{
    return viewer->max_depth > 0 ? viewer->max_depth : viewer->world.limits.maxDepth;
}

// Take one event of SDL.
void controls_take(Viewer *viewer, const SDL_Event *event);

// What the keys that are held ask for in `seconds`, and what the mouse has asked for; the latter is
// then taken.
Motion controls_motion(Viewer *viewer, f32 seconds);

// A line of the list of keys: what is pressed and what it does; NULL behind the last.
typedef struct ControlLine {
    const char *keys, *meaning;
} ControlLine;
const ControlLine *controls_help(int i);

// Draw the panel, and over the picture the mark of the pixel that is followed and the help.
void panel_draw(Viewer *viewer);

// Where the slider of the tree's depth stands, and which depth is at x.
Box panel_slider(const Viewer *viewer);
int panel_slider_depth(const Viewer *viewer, int x);

#endif
