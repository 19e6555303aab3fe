// Keys and the mouse (see viewer.h). One table says what each key does, and is the help's as well.
//
// Read next: view.c.
#include "number.h"
#include "viewer.h"

#include <math.h>
#include <stdlib.h>

// ---- Keys that are held -----------------------------------------------------------------------

// A key of flight, and what a second of it adds to the motion.
static const struct HeldKey {
    SDL_Keycode key;
    Motion a_second;
} HELD_KEYS[] = {
    {SDLK_w, {.forward = 1}},
    {SDLK_s, {.forward = -1}},
    {SDLK_a, {.right = -1}},
    {SDLK_d, {.right = 1}},
    {SDLK_e, {.up = 1}},
    {SDLK_q, {.up = -1}},
    {SDLK_LEFT, {.orbit_right = -1}},
    {SDLK_RIGHT, {.orbit_right = 1}},
    {SDLK_UP, {.orbit_up = 1}},
    {SDLK_DOWN, {.orbit_up = -1}},
};
enum { N_HELD_KEYS = sizeof HELD_KEYS / sizeof HELD_KEYS[0] };

// The middle of the orbit is gone round in this many seconds, where it goes by itself.
static const f32 ORBIT_SECONDS = 12;

// Radians for each pixel that the mouse is drawn.
static const f32 RADIANS_A_PIXEL = 0.005f;

static Motion motion_sum(Motion a, Motion b, f32 factor)
{
    a.right += factor * b.right;
    a.up += factor * b.up;
    a.forward += factor * b.forward;
    a.orbit_right += factor * b.orbit_right;
    a.orbit_up += factor * b.orbit_up;
    return a;
}

Motion controls_motion(Viewer *viewer, f32 seconds)
{
    Motion motion = viewer->motion;
    viewer->motion = (Motion){0};
    for (int i = 0; i < N_HELD_KEYS; i++) {
        if (viewer->keys_held & 1u << i) {
            motion = motion_sum(motion, HELD_KEYS[i].a_second, seconds);
        }
    }
    if (viewer->orbits) {
        motion.orbit_right += (f32)(2 * M_PI) / ORBIT_SECONDS * seconds;
    }
    return motion;
}

// ---- Keys that are pressed --------------------------------------------------------------------

// Draw with a kernel and its tree. Returns NULL, or why not, for the note: then nothing changes.
static const char *kernel_use(Viewer *viewer, const WorldKernel *kernel)
{
    World *world = &viewer->world;
    const WorldTree *before = world->tree;
    const int depth_before = world->max_depth;
    const int is_new_tree = kernel->tree != NULL && kernel->tree != before;
    if (is_new_tree && world_grow(world, kernel->tree, viewer->max_depth) != 0) {
        return "no such tree: see the terminal";
    }
    if (frame_use(&viewer->frame, world, kernel) == 0) {
        return NULL;
    }
    if (is_new_tree) {
        // It was built like this before.
        world_grow(world, before, depth_before);
    }
    return "the kernel does not build: see the terminal";
}

static void kernel_next(Viewer *viewer)
{
    const int next = (viewer->kernel + 1) % viewer->n_kernels;
    if (next == viewer->kernel) {
        viewer->note = "this lab has no other kernel";
        return;
    }
    viewer->note = kernel_use(viewer, &viewer->kernels[next]);
    if (viewer->note == NULL) {
        viewer->kernel = next;
        viewer->is_drawn = 0;
    }
}

static void kernel_again(Viewer *viewer)
{
    viewer->note = kernel_use(viewer, viewer_kernel(viewer));
    viewer->note = viewer->note == NULL ? "built anew" : viewer->note;
    viewer->is_drawn = 0;
}

// Does the kernel at hand send rays on from what they hit? If not, the user is told.
static int asks_bounces(Viewer *viewer)
{
    const int has_bounces = viewer_kernel(viewer)->has_bounces;
    viewer->note = has_bounces ? NULL : "no shadows, no mirrors in this kernel";
    return has_bounces;
}

static void shadows_switch(Viewer *viewer)
{
    World *world = &viewer->world;
    if (!asks_bounces(viewer)) {
        return;
    }
    world->has_shadows = !world->has_shadows;
    viewer->note = kernel_use(viewer, viewer_kernel(viewer));
    if (viewer->note != NULL) {
        world->has_shadows = !world->has_shadows;
    }
    viewer->is_drawn = 0;
}

static void bounces_set(Viewer *viewer, int n_bounces)
{
    if (!asks_bounces(viewer)) {
        return;
    }
    if (n_bounces < 0 || n_bounces > OPTIONS_MOST_BOUNCES) {
        viewer->note = n_bounces < 0
                           ? "there are no fewer mirrors than none"
                           : "no more than " NUMBER_TEXT(OPTIONS_MOST_BOUNCES) " mirrors are met";
        return;
    }
    viewer->world.n_bounces = n_bounces;
    viewer->is_drawn = 0;
}

static void bounces_more(Viewer *viewer)
{
    bounces_set(viewer, viewer->world.n_bounces + 1);
}

static void bounces_less(Viewer *viewer)
{
    bounces_set(viewer, viewer->world.n_bounces - 1);
}

static void heat_switch(Viewer *viewer)
{
    if (viewer->world.kind->elements == NULL) {
        viewer->note = "no work is counted in this lab";
        return;
    }
    viewer->shows_heat = !viewer->shows_heat;
}

static void orbit_switch(Viewer *viewer)
{
    viewer->orbits = !viewer->orbits;
}

static void help_switch(Viewer *viewer)
{
    viewer->shows_help = !viewer->shows_help;
}

static void depth_set(Viewer *viewer, int depth)
{
    viewer->max_depth = depth < SHALLOWEST ? SHALLOWEST : depth > DEEPEST ? DEEPEST : depth;
}

static void depth_more(Viewer *viewer)
{
    // Trees by cost stop by themselves, and may be given more levels than the slider has.
    if (viewer_depth(viewer) < DEEPEST) {
        depth_set(viewer, viewer_depth(viewer) + 1);
    }
}

static void depth_less(Viewer *viewer)
{
    depth_set(viewer, viewer_depth(viewer) - 1);
}

static void zoom_in(Viewer *viewer)
{
    viewer->motion.notches++;
}

static void zoom_out(Viewer *viewer)
{
    viewer->motion.notches--;
}

static void path_restart(Viewer *viewer)
{
    viewer->restarts_path = 1;
}

static void home_go(Viewer *viewer)
{
    viewer->world.pose = viewer->world.home;
    viewer->is_placed = viewer->orbits = 0;
}

static void picture_save(Viewer *viewer)
{
    const char *path = viewer->world.lab->options.output;
    const int result = image_save(&viewer->frame.picture, path);
    viewer->note = result == 0 ? path : "not saved: see the terminal";
}

static void steps_scroll(Viewer *viewer, int n_lines)
{
    const int last = viewer->n_lines - 1;
    const int first = viewer->first_line + n_lines;
    viewer->first_line = first < 0 ? 0 : first > last ? last : first;
}

enum { LINES_A_PAGE = 10, LINES_A_NOTCH = 3 };

static void steps_down(Viewer *viewer)
{
    steps_scroll(viewer, LINES_A_PAGE);
}

static void steps_up(Viewer *viewer)
{
    steps_scroll(viewer, -LINES_A_PAGE);
}

static void pixel_forget(Viewer *viewer)
{
    viewer->is_following = 0;
}

static void view_end(Viewer *viewer)
{
    viewer->ends = 1;
}

static const struct PressedKey {
    SDL_Keycode key;
    void (*act)(Viewer *viewer);
    ControlLine help;  // empty for a key that does what the one above it does
} PRESSED_KEYS[] = {
    {SDLK_n, kernel_next, {"N", "the next kernel: fast, kd-tree, naive"}},
    {SDLK_m, heat_switch, {"M", "heat map of the counted work"}},
    {SDLK_PLUS, depth_more, {"+ -", "a level more or less of the tree; or drag"}},
    {SDLK_EQUALS, depth_more, {0}},
    {SDLK_KP_PLUS, depth_more, {0}},
    {SDLK_MINUS, depth_less, {0}},
    {SDLK_KP_MINUS, depth_less, {0}},
    {SDLK_l, shadows_switch, {"L", "labs 09, 10: shadows on and off"}},
    {SDLK_v, bounces_less, {"V B", "labs 09, 10: a mirror less, one more"}},
    {SDLK_b, bounces_more, {0}},
    {SDLK_z, zoom_in, {"Z X, wheel", "nearer, farther"}},
    {SDLK_x, zoom_out, {0}},
    {SDLK_o, orbit_switch, {"O", "go round by itself"}},
    {SDLK_f, path_restart, {"F", "fly the path of --path, from its start"}},
    {SDLK_HOME, home_go, {"Home", "back to the scene's own view"}},
    {SDLK_c, pixel_forget, {"C", "follow no pixel any more"}},
    {SDLK_PAGEDOWN, steps_down, {"Page Up, Down", "through its steps; or the wheel"}},
    {SDLK_PAGEUP, steps_up, {0}},
    {SDLK_r, kernel_again, {"R", "read and build your kernel again"}},
    {SDLK_p, picture_save, {"P", "save the picture to --output"}},
    {SDLK_h, help_switch, {"H", "these lines"}},
    {SDLK_ESCAPE, view_end, {"Esc", "end"}},
};
enum { N_PRESSED_KEYS = sizeof PRESSED_KEYS / sizeof PRESSED_KEYS[0] };

// Keys of flight and the mouse, for the help.
static const ControlLine FLIGHT_HELP[] = {
    {"W S A D", "fly: on, back, left, right"}, {"E Q", "fly up, down"},
    {"arrows", "go round the scene"},          {"left drag", "look round; 2D: pull the scene"},
    {"right drag", "go round the scene"},      {"click", "follow this pixel"},
};
enum { N_FLIGHT_HELP = sizeof FLIGHT_HELP / sizeof FLIGHT_HELP[0] };

const ControlLine *controls_help(int i)
{
    if (i < N_FLIGHT_HELP) {
        return &FLIGHT_HELP[i];
    }
    i -= N_FLIGHT_HELP;
    for (int key = 0; key < N_PRESSED_KEYS; key++) {
        if (PRESSED_KEYS[key].help.keys != NULL && i-- == 0) {
            return &PRESSED_KEYS[key].help;
        }
    }
    return NULL;
}

static void key_take(Viewer *viewer, const SDL_KeyboardEvent *event)
{
    const int is_down = event->type == SDL_KEYDOWN;
    // A key that is held is pressed once.
    if (event->repeat) {
        return;
    }
    if (is_down) {
        viewer->note = NULL;
        viewer->key_at_ms = stats_clock_ms() - (double)(SDL_GetTicks() - event->timestamp);
    }
    for (int i = 0; i < N_HELD_KEYS; i++) {
        if (HELD_KEYS[i].key == event->keysym.sym) {
            const unsigned bit = 1u << i;
            viewer->keys_held = is_down ? viewer->keys_held | bit : viewer->keys_held & ~bit;
        }
    }
    for (int i = 0; is_down && i < N_PRESSED_KEYS; i++) {
        if (PRESSED_KEYS[i].key == event->keysym.sym) {
            PRESSED_KEYS[i].act(viewer);
        }
    }
}

// ---- The mouse --------------------------------------------------------------------------------

static int is_in(Box box, int x, int y)
{
    return x >= box.x && x < box.x + box.w && y >= box.y && y < box.y + box.h;
}

static void button_take(Viewer *viewer, int button, int x, int y)
{
    const int is_on_picture = x < viewer->world.width && y < viewer->world.height;
    viewer->has_dragged = 0;
    viewer->grip_x = x;
    viewer->grip_y = y;
    if (viewer->world.tree != NULL && is_in(panel_slider(viewer), x, y)) {
        viewer->grip = GRIP_SLIDER;
        depth_set(viewer, panel_slider_depth(viewer, x));
    } else if (is_on_picture) {
        viewer->grip = button == SDL_BUTTON_LEFT ? GRIP_LOOK : GRIP_ORBIT;
    }
}

// A press and a release in one place mean the pixel there.
static void button_let_go(Viewer *viewer, int button)
{
    if (viewer->grip == GRIP_LOOK && button == SDL_BUTTON_LEFT && !viewer->has_dragged &&
        viewer_kernel(viewer)->steps_path != NULL) {
        viewer->pixel_x = viewer->grip_x;
        viewer->pixel_y = viewer->grip_y;
        viewer->is_following = 1;
        viewer->is_followed = viewer->is_told = 0;
    }
    viewer->grip = GRIP_NONE;
}

// A hand that presses is not quite still.
enum { STILL_PIXELS = 2 };

static void mouse_take(Viewer *viewer, int x, int y)
{
    const int right = x - viewer->grip_x, down = y - viewer->grip_y;
    if (viewer->grip == GRIP_SLIDER) {
        depth_set(viewer, panel_slider_depth(viewer, x));
        return;
    }
    viewer->has_dragged |= abs(right) > STILL_PIXELS || abs(down) > STILL_PIXELS;
    if (viewer->grip == GRIP_NONE || !viewer->has_dragged) {
        return;
    }
    Motion *motion = &viewer->motion;
    if (viewer->grip == GRIP_LOOK) {
        motion->turn_right += RADIANS_A_PIXEL * (f32)right;
        motion->turn_up -= RADIANS_A_PIXEL * (f32)down;
        motion->drag_right += (f32)right;
        motion->drag_down += (f32)down;
    } else {
        // The scene is turned as if by hand: the eye goes the other way.
        motion->orbit_right -= RADIANS_A_PIXEL * (f32)right;
        motion->orbit_up += RADIANS_A_PIXEL * (f32)down;
    }
    viewer->grip_x = x;
    viewer->grip_y = y;
}

static void wheel_take(Viewer *viewer, const SDL_MouseWheelEvent *event)
{
    int x = event->mouseX, y = event->mouseY;
    window_to_canvas(&viewer->window, &x, &y);
    if (x < viewer->world.width) {
        viewer->motion.notches += event->y;
    } else {
        steps_scroll(viewer, -event->y * LINES_A_NOTCH);
    }
}

void controls_take(Viewer *viewer, const SDL_Event *event)
{
    int x = event->button.x, y = event->button.y;
    switch (event->type) {
    case SDL_QUIT:
        viewer->ends = 1;
        break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        key_take(viewer, &event->key);
        break;
    case SDL_MOUSEBUTTONDOWN:
        window_to_canvas(&viewer->window, &x, &y);
        button_take(viewer, event->button.button, x, y);
        break;
    case SDL_MOUSEBUTTONUP:
        button_let_go(viewer, event->button.button);
        break;
    case SDL_MOUSEMOTION:
        x = event->motion.x, y = event->motion.y;
        window_to_canvas(&viewer->window, &x, &y);
        mouse_take(viewer, x, y);
        break;
    case SDL_MOUSEWHEEL:
        wheel_take(viewer, &event->wheel);
        break;
    default:
        break;
    }
    // Whatever has come, the window may look otherwise now.
    viewer->is_shown = 0;
}
