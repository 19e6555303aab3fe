// One pixel of a lab, followed: `make pixel LAB=07 AT=200,120`. What there is to follow comes from
// the lab's own file, NN-name.c.
//
// Read next: followed.h.
#include "complain.h"
#include "followed.h"
#include "standard_streams.h"

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

// A student's kernel may never end. One pixel takes no kernel that long. Processor time counts, as
// other programs may keep the machine busy; by the clock, as a GPU computes without a processor,
// it may take ten times as long.
enum { LONGEST_SECONDS = 120, LONGEST_WAIT = 10 * LONGEST_SECONDS };

static void give_up(int signal_number)
{
    static const char MESSAGE[] = "the kernel does not end: is there a loop that never does?\n";
    (void)signal_number;
    _exit(write(STDERR_FILENO, MESSAGE, sizeof MESSAGE - 1) < 0 ? EXIT_FAILURE : EXIT_FAILURE);
}

// Give up after these seconds from now on; 0 for never.
static void give_up_after(int processor_seconds, int seconds)
{
    const struct itimerval limit = {.it_value = {.tv_sec = processor_seconds}};
    signal(SIGPROF, give_up);
    signal(SIGALRM, give_up);
    setitimer(ITIMER_PROF, &limit, NULL);
    alarm((unsigned)seconds);
}

// Is there such a pixel? Returns 0, or -1 after one message.
static int pixel_check(const World *world)
{
    const Options *options = &world->lab->options;
    if (options->pixel_x < 0) {
        complain("%s: say which pixel: --pixel X,Y", world->lab->name);
        return -1;
    }
    if (options->pixel_x >= world->width || options->pixel_y >= world->height) {
        complain("%s: --pixel: found \"%d,%d\", expected X from 0 to %d and Y from 0 to %d",
                 world->lab->name, options->pixel_x, options->pixel_y, world->width - 1,
                 world->height - 1);
        return -1;
    }
    return 0;
}

int main(int argc, char **argv)
{
    Lab lab = lab_begin(argc, argv, WORLD_LAB.name, "Follows one pixel, step by step.",
                        world_options(&WORLD_LAB) | OPTIONS_PIXEL);
    World world;
    require(world_open(&world, &lab, &WORLD_LAB));
    require(pixel_check(&world));

    Followed *followed = world_allocate(sizeof *followed);
    give_up_after(LONGEST_SECONDS, LONGEST_WAIT);
    require(followed_make(followed, &world, &WORLD_LAB, lab.options.pixel_x, lab.options.pixel_y));
    give_up_after(0, 0);

    followed_print(followed, stdout);
    if (lab.options.json != NULL) {
        require(followed_save_json(followed, lab.options.json));
    }
    if (lab.options.svg != NULL) {
        require(followed_save_svg(followed, lab.options.svg));
    }
    require(standard_output_check());

    free(followed);
    world.kind->close(&world);
    cl_setup_close(&lab.cl);
    return EXIT_SUCCESS;
}
