// How much time a submission may use (see allowance.h).
#include "allowance.h"

#include "complain.h"
#include "number.h"
#include "sandbox_clock.h"
#include "text_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// A right answer may be slower than ours, or meet a processor that is shared with others. It may
// take this many times what ours used, and never less than the floor, as short times vary most.
// What a handout knows is rounded up already.
#define FACTOR 6.0
#define PACKED_FACTOR 4.0
#define FLOOR_SECONDS 5.0

// Once a submission is known to have an endless loop, it is met again where its answer is tried
// alone. An answer alone does less than the whole.
#define LOOPING_SHARE 0.5

// All runs together: the whole takes a quarter at most, or half where its compiler is as slow. What
// never ends in one task or two takes less than the rest.
#define TOTAL_FACTOR 4.0

// A command that gets a thirtieth of a processor still ends by its processor time.
#define WALL_FACTOR 30.0

// Nothing is begun so shortly before the deadline: OpenCL alone takes a second or two to start, and
// what it comes to then would tell of the machine.
#define LAST_START_SECONDS 3.0

enum { OUR_SECONDS = 600 };

static double allowed(double used, double factor)
{
    return used * factor > FLOOR_SECONDS ? used * factor : FLOOR_SECONDS;
}

SandboxTime allowance_ours(void)
{
    return (SandboxTime){OUR_SECONDS, OUR_SECONDS, WALL_FACTOR * OUR_SECONDS};
}

// What a step may use if nothing else has run.
static SandboxTime allowed_first(const Allowance *allowance, Step step)
{
    const double given = allowance->given_seconds;
    if (given > 0) {
        return (SandboxTime){given, given, WALL_FACTOR * given};
    }
    if (!allowance->is_known[step]) {
        return allowance_ours();
    }
    const SandboxTime *used = &allowance->solution[step];
    const double factor = allowance->is_packed ? PACKED_FACTOR : FACTOR;
    const double processor = allowed(used->processor, factor);
    return (SandboxTime){processor, allowed(used->asleep, factor), WALL_FACTOR * processor};
}

double allowance_total(const Allowance *allowance)
{
    const SandboxTime step = allowed_first(allowance, STEP_RUNNING);
    return TOTAL_FACTOR * (step.processor + step.asleep);
}

// What is left `seconds` from now, should nothing be used until then.
static double left_in(const Allowance *allowance, double seconds)
{
    const int is_late = allowance->deadline > 0 && seconds_now() + seconds >= allowance->deadline;
    return is_late                 ? 0
           : allowance->is_for_one ? allowance_total(allowance) - allowance->spent
                                   : INFINITY;
}

double allowance_left(const Allowance *allowance)
{
    return left_in(allowance, LAST_START_SECONDS);
}

static double at_most(double seconds, double most)
{
    return fmax(1, fmin(seconds, most));
}

SandboxTime allowance_of(const Allowance *allowance, Step step, int n)
{
    SandboxTime time = allowed_first(allowance, step);
    if (allowance->is_looping && allowance->given_seconds == 0) {
        time.processor *= LOOPING_SHARE;
        time.asleep *= LOOPING_SHARE;
    }
    const double left = left_in(allowance, 0) / n;
    time.processor = at_most(time.processor, left);
    time.asleep = at_most(time.asleep, left);
    if (allowance->deadline > 0) {
        time.wall = at_most(time.wall, allowance->deadline - seconds_now());
    }
    return time;
}

void allowance_charge(Allowance *allowance, const SandboxResult *result)
{
    // Where its wall time went, nobody saw. It was thirty times what it may use: that is enough.
    allowance->spent += result->outcome == SANDBOX_OVERDUE
                            ? allowance_total(allowance)
                            : result->used.processor + result->used.asleep;
}

void allowance_note(Allowance *allowance, Step step, SandboxTime used)
{
    allowance->is_known[step] = 1;
    allowance->solution[step] = used;
}

int allowance_read_packed(Allowance *allowance)
{
    uint64_t seconds;
    char *text = text_file_read(SOLUTION_SECONDS_PATH);
    if (text == NULL) {
        return -1;
    }
    text[strcspn(text, "\n")] = '\0';
    const int result = number_read_unsigned(text, 1, OUR_SECONDS, &seconds);
    if (result != 0) {
        complain(SOLUTION_SECONDS_PATH ": found \"%.20s\", expected whole seconds", text);
    }
    allowance->is_packed = 1;
    for (Step step = 0; result == 0 && step < N_STEPS; step++) {
        allowance_note(allowance, step, (SandboxTime){.processor = (double)seconds});
    }
    free(text);
    return result;
}
