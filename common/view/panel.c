// The panel beside the picture, and what lies over it (see viewer.h).
//
// Read next: window.h.
#include "message.h"
#include "viewer.h"

#include <stdarg.h>
#include <stdio.h>

static const Colour PAPER = 0x171a20, INK = 0xe6e9ee, SOFT = 0x98a2b3, LINE = 0x363d49,
                    ACCENT = 0xf2c14e;

enum { MARGIN = 14, SLIDER_HEIGHT = 16, LEGEND_HEIGHT = 12, GAP = 8, N_LEGEND_NUMBERS = 5 };

// Where the sections of the panel begin, pixels from the top; all one line lower in a lab with
// bounces, which has something more to say above them.
enum { TOP_OF_WORK = 160, TOP_OF_TREE = 262, TOP_OF_LEGEND = 350, TOP_OF_STEPS = 408 };

static int section_top(const Viewer *viewer, int top)
{
    return top + (viewer_find_bouncing(viewer) >= 0 ? viewer->window.line_height : 0);
}

typedef struct Pen {
    Viewer *viewer;
    int y;  // where the next line is written
} Pen;

static int panel_left(const Viewer *viewer)
{
    return viewer->world.width + MARGIN;
}

enum { TEXT_WIDTH = PANEL_WIDTH - 2 * MARGIN };

__attribute__((format(printf, 3, 4))) static void write_line(Pen *pen, Colour colour,
                                                             const char *format, ...)
{
    char text[160];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    Window *window = &pen->viewer->window;
    const Box box = {panel_left(pen->viewer), pen->y, TEXT_WIDTH, window->line_height};
    window_text(window, box, colour, text);
    pen->y += window->line_height;
}

static void write_rule(Pen *pen)
{
    const Box rule = {panel_left(pen->viewer), pen->y - GAP, TEXT_WIDTH, 1};
    window_fill(&pen->viewer->window, rule, LINE);
}

// ---- What is drawn, and how fast ----------------------------------------------------------------

static void bounces_write(Viewer *viewer, Pen *pen)
{
    const World *world = &viewer->world;
    if (viewer_kernel(viewer)->has_bounces) {
        write_line(pen, INK, "shadows %s (L), up to %d mirror%s (V B)",
                   world->has_shadows ? "on" : "off", world->n_bounces,
                   plural((u32)world->n_bounces));
    } else {
        write_line(pen, SOFT, "no shadows, no mirrors");
    }
}

static void speed_write(Viewer *viewer)
{
    const World *world = &viewer->world;
    const WorldKind *kind = world->kind;
    Pen pen = {viewer, MARGIN};
    write_line(&pen, ACCENT, "%s: %s", world->lab->name, viewer_kernel(viewer)->label);
    write_line(&pen, SOFT, "%s", world->lab->options.scene);
    if (kind->elements != NULL) {
        write_line(&pen, SOFT, "%d %s, %dx%d pixels", world->n_elements, kind->elements,
                   world->width, world->height);
    } else {
        write_line(&pen, SOFT, "%dx%d pixels", world->width, world->height);
    }
    write_line(&pen, SOFT, "%.40s", world->lab->cl.device_name);
    pen.y += GAP;
    const double n_pixels = (double)world->width * world->height;
    const double seconds = viewer->frame.draw_ms / 1000;
    // Nothing is known of the first one while it is drawn.
    write_line(&pen, INK, "%8.1f frames a second",
               viewer->frame_ms > 0 ? 1000 / viewer->frame_ms : 0);
    write_line(&pen, INK, "%8.2f million %s a second", n_pixels / seconds / 1e6, kind->askers);
    write_line(&pen, INK, "%8.0f ms from key to frame", viewer->latency_ms);
    if (viewer_find_bouncing(viewer) >= 0) {
        bounces_write(viewer, &pen);
    }
}

// ---- Counted work -------------------------------------------------------------------------------

static const char *unit(const Viewer *viewer)
{
    return viewer_kernel(viewer)->unit != NULL ? viewer_kernel(viewer)->unit : "pixel";
}

static void work_write(Viewer *viewer)
{
    const WorldKind *kind = viewer->world.kind;
    const char *const names[N_COUNTERS] = {kind->elements, "inner nodes", "leaves",
                                           "waiting nodes"};
    const int n_counters = kind == &CIRCLES ? 2 : N_COUNTERS;
    Pen pen = {viewer, section_top(viewer, TOP_OF_WORK)};
    write_rule(&pen);
    if (kind->elements == NULL) {
        write_line(&pen, SOFT, "no work is counted: a ray asks nothing");
        return;
    }
    char title[32];
    snprintf(title, sizeof title, "work of a %s", unit(viewer));
    write_line(&pen, SOFT, "%-20s %9s %9s", title, "mean", "most");
    for (int i = 0; i < n_counters; i++) {
        // While something moves, the figures are those of the last frame that stood still.
        write_line(&pen, viewer->is_counted ? INK : SOFT, "%-20s %9.2f %9u", names[i],
                   viewer->frame.work.mean[i], viewer->frame.work.most[i]);
    }
}

// Black for no step, the brightest colour for the most of any in this picture.
static void legend_draw(Viewer *viewer)
{
    Window *window = &viewer->window;
    if (viewer->world.kind->elements == NULL) {
        return;
    }
    const u32 most = viewer->frame.work.most_steps;
    Pen pen = {viewer, section_top(viewer, TOP_OF_LEGEND)};
    write_rule(&pen);
    write_line(&pen, viewer->shows_heat ? INK : SOFT, "steps of a %s (M: heat map %s)",
               unit(viewer), viewer->shows_heat ? "off" : "on");
    for (int x = 0; x < TEXT_WIDTH; x++) {
        float rgb[3];
        image_heat_colour((float)x / (TEXT_WIDTH - 1), rgb);
        const Colour colour =
            (Colour)(rgb[0] * 255) << 16 | (Colour)(rgb[1] * 255) << 8 | (Colour)(rgb[2] * 255);
        window_fill(window, (Box){panel_left(viewer) + x, pen.y, 1, LEGEND_HEIGHT}, colour);
    }
    for (int i = 0; i < N_LEGEND_NUMBERS; i++) {
        char number[16];
        const int length =
            snprintf(number, sizeof number, "%.0f", (double)most * i / (N_LEGEND_NUMBERS - 1));
        // The first number begins where the colours do, the last ends with them.
        const int free_width = TEXT_WIDTH - length * window->char_width;
        const int x = panel_left(viewer) + free_width * i / (N_LEGEND_NUMBERS - 1);
        window_text(window, (Box){x, pen.y + LEGEND_HEIGHT, TEXT_WIDTH, window->line_height}, SOFT,
                    number);
    }
}

// ---- The tree -----------------------------------------------------------------------------------

Box panel_slider(const Viewer *viewer)
{
    const int top = section_top(viewer, TOP_OF_TREE) + viewer->window.line_height;
    return (Box){panel_left(viewer), top, TEXT_WIDTH, SLIDER_HEIGHT};
}

int panel_slider_depth(const Viewer *viewer, int x)
{
    const Box slider = panel_slider(viewer);
    const int n_steps = DEEPEST - SHALLOWEST;
    return SHALLOWEST + ((x - slider.x) * n_steps + slider.w / 2) / slider.w;
}

static void tree_draw(Viewer *viewer)
{
    const TreeFigures *figures = &viewer->world.figures;
    Window *window = &viewer->window;
    Pen pen = {viewer, section_top(viewer, TOP_OF_TREE)};
    write_rule(&pen);
    if (viewer->world.tree == NULL) {
        write_line(&pen, SOFT, "no tree: it comes with a later lab");
        return;
    }
    const int max_depth = viewer_depth(viewer);
    write_line(&pen, INK, "tree: at most %d levels (+ -)", max_depth);
    const Box slider = panel_slider(viewer);
    const int middle = slider.y + slider.h / 2;
    const int shown = max_depth < DEEPEST ? max_depth : DEEPEST;
    const int knob = (slider.w - GAP) * (shown - SHALLOWEST) / (DEEPEST - SHALLOWEST);
    window_fill(window, (Box){slider.x, middle - 1, slider.w, 3}, LINE);
    window_fill(window, (Box){slider.x, middle - 1, knob, 3}, ACCENT);
    window_fill(window, (Box){slider.x + knob, slider.y, GAP, slider.h}, ACCENT);
    pen.y = slider.y + slider.h;
    write_line(&pen, SOFT, "has %d levels, %u nodes", figures->depth, figures->n_nodes);
    write_line(&pen, SOFT, "lists %u %s, %.1f ms to build", figures->n_listed,
               viewer->world.kind->elements, figures->build_ms);
}

// ---- The pixel that is followed -----------------------------------------------------------------

static void steps_write(Viewer *viewer)
{
    Pen pen = {viewer, section_top(viewer, TOP_OF_STEPS)};
    write_rule(&pen);
    if (viewer_kernel(viewer)->steps_path == NULL) {
        write_line(&pen, SOFT, "%s", viewer_kernel(viewer)->not_followed);
        write_line(&pen, SOFT, "H: all keys");
        return;
    }
    if (!viewer->is_following) {
        write_line(&pen, SOFT, "click a pixel to follow it; H: all keys");
        return;
    }
    const u32 n_steps = viewer->steps.n_steps > 0 ? viewer->steps.n_steps - 1 : 0;
    write_line(&pen, ACCENT, "pixel %d, %d: %u steps", viewer->pixel_x, viewer->pixel_y, n_steps);
    const int n_lines = viewer->n_lines - 1;
    if (n_lines < 0) {
        return;
    }
    write_line(&pen, ACCENT, "%s", viewer->lines[n_lines].text);
    const int bottom = viewer->window.canvas->h - MARGIN - 2 * viewer->window.line_height;
    int line = viewer->first_line;
    for (; line < n_lines && pen.y < bottom; line++) {
        write_line(&pen, INK, "%s", viewer->lines[line].text);
    }
    if (line < n_lines) {
        write_line(&pen, SOFT, "%d more lines", n_lines - line);
    }
}

// A cross with a hole, so that the pixel itself is seen.
static void mark_draw(Viewer *viewer)
{
    enum { ARM = 9, HOLE = 3 };
    const int x = viewer->pixel_x, y = viewer->pixel_y;
    const Box arms[] = {{x - ARM, y, ARM - HOLE, 1},
                        {x + HOLE + 1, y, ARM - HOLE, 1},
                        {x, y - ARM, 1, ARM - HOLE},
                        {x, y + HOLE + 1, 1, ARM - HOLE}};
    for (size_t i = 0; i < sizeof arms / sizeof *arms; i++) {
        window_fill(&viewer->window, arms[i], ACCENT);
    }
}

// ---- The help -----------------------------------------------------------------------------------

static void help_draw(Viewer *viewer)
{
    enum { KEYS_WIDTH = 118, HELP_WIDTH = 490 };
    Window *window = &viewer->window;
    int n_lines = 0;
    while (controls_help(n_lines) != NULL) {
        n_lines++;
    }
    const Box box = {MARGIN, MARGIN, HELP_WIDTH, n_lines * window->line_height + 2 * MARGIN};
    window_fill(window, box, PAPER);
    window_outline(window, box, LINE);
    Box line = {box.x + MARGIN, box.y + MARGIN, HELP_WIDTH - 2 * MARGIN, window->line_height};
    for (int i = 0; i < n_lines; i++, line.y += window->line_height) {
        window_text(window, line, ACCENT, controls_help(i)->keys);
        const Box meaning = {line.x + KEYS_WIDTH, line.y, line.w - KEYS_WIDTH, line.h};
        window_text(window, meaning, INK, controls_help(i)->meaning);
    }
}

void panel_draw(Viewer *viewer)
{
    Window *window = &viewer->window;
    if (viewer->is_following && viewer_kernel(viewer)->steps_path != NULL) {
        mark_draw(viewer);
    }
    const int width = viewer->world.width, height = viewer->world.height;
    window_fill(window, (Box){width, 0, window->canvas->w - width, window->canvas->h}, PAPER);
    window_fill(window, (Box){0, height, width, window->canvas->h - height}, PAPER);
    speed_write(viewer);
    work_write(viewer);
    tree_draw(viewer);
    legend_draw(viewer);
    steps_write(viewer);
    if (viewer->note != NULL) {
        Pen pen = {viewer, window->canvas->h - MARGIN - window->line_height};
        write_line(&pen, ACCENT, "%s", viewer->note);
    }
    if (viewer->shows_help) {
        help_draw(viewer);
    }
}
