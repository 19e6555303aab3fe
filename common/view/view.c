// The window of a lab, round and round (see view.h): take what the user wants, move, draw, show.
//
// Only what has changed is drawn anew. Where nothing moves, the work is counted, the followed pixel
// is asked for its steps, and then the program sleeps until something happens.
// Read next: controls.c, frame.c, panel.c.
#include "view.h"

#include "film.h"
#include "poses.h"
#include "script.h"
#include "viewer.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// ---- One frame --------------------------------------------------------------------------------

// Move, and bring the device's data up to date.
static void world_update(Viewer *viewer, Motion motion)
{
    World *world = &viewer->world;
    const Pose before = world->pose;
    world->kind->move(world, motion);
    if (memcmp(&before, &world->pose, sizeof before) != 0) {
        viewer->is_placed = 0;
    }
    if (world->tree != NULL && viewer->max_depth != world->max_depth) {
        if (world_grow(world, world->tree, viewer->max_depth) != 0) {
            viewer->max_depth = world->max_depth;
            viewer->note = "no such tree: see the terminal";
        }
        viewer->is_drawn = 0;
    }
    if (!viewer->is_placed) {
        if (world->kind->place(world) != 0) {
            viewer->note = "no tree for this place: see the terminal";
        }
        viewer->is_placed = 1;
        viewer->is_drawn = 0;
    }
}

// Draw what has changed.
static void frame_update(Viewer *viewer)
{
    if (!viewer->is_drawn) {
        frame_draw(&viewer->frame, &viewer->world);
        viewer->is_drawn = 1;
        viewer->is_counted = viewer->is_followed = viewer->is_shown = 0;
    }
    // A heat map is made of counters, so there they are needed at once.
    if (viewer->shows_heat && !viewer->is_counted) {
        frame_count(&viewer->frame, &viewer->world);
        viewer->is_counted = 1;
    }
}

// Ask the followed pixel for its steps.
static void pixel_update(Viewer *viewer)
{
    viewer->is_followed = 1;
    viewer->is_shown = 0;
    if (record_pixel(&viewer->world, viewer_kernel(viewer), viewer->pixel_x, viewer->pixel_y,
                     &viewer->steps) != 0) {
        viewer->is_following = 0;
        viewer->note = "no steps: see the terminal";
        return;
    }
    viewer->n_lines = panel_lines(&viewer->world, &viewer->steps, viewer->lines);
    viewer->first_line = 0;
    if (viewer->is_told) {
        return;
    }
    // After a click they go to the terminal as well, to be copied and compared.
    printf("pixel %d, %d:\n", viewer->pixel_x, viewer->pixel_y);
    for (int i = 0; i < viewer->n_lines; i++) {
        printf("%s\n", viewer->lines[i].text);
    }
    fflush(stdout);
    viewer->is_told = 1;
}

// What has time until nothing moves.
static void still_update(Viewer *viewer)
{
    if (!viewer->is_counted && viewer->world.kind->elements != NULL) {
        frame_count(&viewer->frame, &viewer->world);
        viewer->is_counted = 1;
        viewer->is_shown = 0;
    }
    if (viewer->is_following && !viewer->is_followed && viewer_kernel(viewer)->steps_path != NULL) {
        pixel_update(viewer);
    }
}

static void window_update(Viewer *viewer)
{
    if (viewer->is_shown) {
        return;
    }
    const Image *picture = &viewer->frame.picture;
    if (viewer->shows_heat) {
        frame_heat_map(&viewer->frame, &viewer->heat);
        picture = &viewer->heat;
    }
    window_picture(&viewer->window, 0, 0, picture);
    panel_draw(viewer);
    window_show(&viewer->window);
    viewer->is_shown = 1;
    if (viewer->key_at_ms > 0) {
        viewer->latency_ms = stats_clock_ms() - viewer->key_at_ms;
        viewer->key_at_ms = 0;
    }
}

// ---- Time -------------------------------------------------------------------------------------

// More are not kept: the figures are of the first ones.
enum { MAX_LATENCIES = 10000 };

// A frame that took longer does not fly farther: nobody steers so.
static const double LONGEST_FRAME_MS = 250;

typedef struct Session {
    Viewer viewer;
    Script script;
    Poses played;
    PosesRecord record;
    double played_s, recorded_s;  // how much of the path is played; how long is recorded
    double latencies[MAX_LATENCIES];
    int n_latencies;
} Session;

// The pose of the path that is played, where it is not at its end.
static void path_play(Session *session, double seconds)
{
    Viewer *viewer = &session->viewer;
    if (viewer->restarts_path) {
        session->played_s = 0;
        viewer->restarts_path = 0;
        viewer->plays = session->played.n > 0;
        viewer->note = viewer->plays ? NULL : "there is no path: start with --path FILE";
    }
    if (!viewer->plays) {
        return;
    }
    const int i = (int)(session->played_s * POSES_A_SECOND + 0.5);
    session->played_s += seconds;
    viewer->plays = i < session->played.n;
    if (viewer->plays) {
        viewer->world.pose = session->played.poses[i];
        viewer->is_placed = 0;
    }
}

// Write down where the world was seen from in these seconds.
static void path_record(Session *session, double seconds)
{
    const World *world = &session->viewer.world;
    session->recorded_s += seconds;
    while (session->record.file != NULL &&
           (double)session->record.n < session->recorded_s * POSES_A_SECOND - 0.5) {
        require(poses_record_add(&session->record, world->kind, &world->pose));
    }
}

static int is_moving(const Viewer *viewer)
{
    return viewer->keys_held != 0 || viewer->orbits || viewer->plays;
}

// One frame, `seconds` after the one before.
static void session_step(Session *session, double seconds)
{
    Viewer *viewer = &session->viewer;
    const double start = stats_clock_ms();
    const int has_key = viewer->key_at_ms > 0;
    path_play(session, seconds);
    world_update(viewer, controls_motion(viewer, (f32)seconds));
    path_record(session, seconds);
    const int is_new = !viewer->is_drawn;
    frame_update(viewer);
    window_update(viewer);
    if (is_new) {
        viewer->frame_ms = stats_clock_ms() - start;
    }
    if (has_key && session->n_latencies < MAX_LATENCIES) {
        session->latencies[session->n_latencies++] = viewer->latency_ms;
    }
    if (!is_moving(viewer)) {
        still_update(viewer);
        window_update(viewer);
    }
}

// With a user at the keyboard.
static void session_live(Session *session)
{
    Viewer *viewer = &session->viewer;
    double clock = stats_clock_ms();
    while (!viewer->ends) {
        const double now = stats_clock_ms();
        session_step(session, fmin(now - clock, LONGEST_FRAME_MS) / 1000);
        clock = now;
        SDL_Event event;
        if (!is_moving(viewer) && SDL_WaitEvent(&event)) {
            controls_take(viewer, &event);
            clock = stats_clock_ms();
        }
        while (SDL_PollEvent(&event)) {
            controls_take(viewer, &event);
        }
    }
}

// With a script. The window's own events are none of its.
static int session_scripted(Session *session)
{
    Viewer *viewer = &session->viewer;
    while (!viewer->ends) {
        SDL_Event event;
        switch (script_next(&session->script, &event)) {
        case SCRIPT_EVENT:
            controls_take(viewer, &event);
            break;
        case SCRIPT_FRAME:
            SDL_PumpEvents();
            SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
            session_step(session, 1.0 / POSES_A_SECOND);
            break;
        case SCRIPT_SAVE:
            if (window_save(&viewer->window, session->script.save) != 0) {
                return -1;
            }
            break;
        case SCRIPT_END:
            return 0;
        case SCRIPT_BAD:
            return -1;
        }
    }
    return 0;
}

// ---- Beginning and end ------------------------------------------------------------------------

static void session_open(Session *session, const Lab *lab)
{
    Viewer *viewer = &session->viewer;
    const Options *options = &lab->options;
    const int width = viewer->world.width + PANEL_WIDTH, height = viewer->world.height;
    viewer->max_depth = viewer->world.max_depth;
    viewer->is_placed = 1;
    if (options->script != NULL) {
        require(script_open(&session->script, options->script));
    }
    if (options->path != NULL) {
        require(poses_read(options->path, viewer->world.kind, &session->played));
        viewer->restarts_path = 1;
    }
    require(image_create(viewer->world.width, height, &viewer->heat));
    require(window_open(&viewer->window, lab->name, width > MIN_WIDTH ? width : MIN_WIDTH,
                        height > MIN_HEIGHT ? height : MIN_HEIGHT));
    if (options->record != NULL) {
        require(poses_record_open(options->record, viewer->world.kind, &session->record));
    }
}

static void session_close(Session *session)
{
    script_close(&session->script);
    poses_free(&session->played);
    image_free(&session->viewer.heat);
    window_close(&session->viewer.window);
}

static void session_run(Session *session, Lab *lab)
{
    session_open(session, lab);
    if (lab->options.script != NULL) {
        require(session_scripted(session));
    } else {
        session_live(session);
    }
    if (session->record.file != NULL) {
        require(poses_record_close(&session->record));
    }
    stats_milliseconds(&lab->stats, "key_to_frame", session->latencies, session->n_latencies);
    session_close(session);
}

static void film_run(Viewer *viewer, const Lab *lab)
{
    Poses path = {0};
    if (lab->options.path != NULL) {
        require(poses_read(lab->options.path, viewer->world.kind, &path));
    }
    require(film_make(&viewer->world, &viewer->frame, &path, lab->options.movie));
    poses_free(&path);
}

int view_run(int argc, char **argv, const WorldLab *world_lab)
{
    Lab lab = lab_begin(argc, argv, world_lab->name, world_lab->what,
                        world_options(world_lab) | OPTIONS_VIEW);
    Session *session = world_allocate(sizeof *session);
    Viewer *viewer = &session->viewer;
    viewer->kernels = world_lab->kernels;
    viewer->n_kernels = world_lab->n_kernels;
    World *world = &viewer->world;
    require(world_open(world, &lab, world_lab));
    lab_describe(&lab, NULL, 0, world->width, world->height);
    require(frame_open(&viewer->frame, world));
    // The lab's own kernel; with --shadows the one that has them.
    const int bouncing = viewer_find_bouncing(viewer);
    viewer->kernel = lab.options.shadows && bouncing >= 0 ? bouncing : 0;
    require(frame_use(&viewer->frame, world, viewer_kernel(viewer)));
    if (lab.options.movie != NULL) {
        film_run(viewer, &lab);
    } else {
        session_run(session, &lab);
    }
    frame_close(&viewer->frame);
    world->kind->close(world);
    free(session);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
