// How much time a submission may use (see allowance.h).
#include "allowance.h"

#include "sandbox_clock.h"

#include <math.h>

// How many times what the solution used a run may take, and the least that it may: short times vary
// most.
typedef struct Limit {
    double factor, floor;
} Limit;

// Solutions use 0.02 to 1.7 s on a machine that others keep busy (an AMD EPYC, PoCL 3.1). At most
// 0.35 s of that is their own work, the rest is the device's compiler's, which every answer needs.
// So a right answer may do ten times as much as ours, or meet a core that another program shares:
// then the same work counts up to twice as much.
static const Limit FIRST = {.factor = 4, .floor = 5};

// An endless loop is met again where its answer is tried alone. A right answer there uses 0.5 to
// 1.5 times what the solution uses in all.
static const Limit AGAIN = {.factor = 2.5, .floor = 2.5};

// All runs together: the whole takes a quarter at most, or half where its compiler is as slow. What
// never ends in one task or two takes less than the rest.
#define TOTAL_FACTOR 4.0

// A command that gets a thirtieth of a processor still ends by its processor time.
#define WALL_FACTOR 30.0

// Nothing is begun so shortly before the deadline: OpenCL alone takes a second or two to start, and
// what it comes to then would tell of the machine.
#define LAST_START_SECONDS 3.0

enum { OUR_SECONDS = 600 };

static double allowed(double used, Limit limit)
{
    return fmax(used * limit.factor, limit.floor);
}

SandboxTime allowance_ours(void)
{
    return (SandboxTime){OUR_SECONDS, OUR_SECONDS, WALL_FACTOR * OUR_SECONDS};
}

// What a step may use if nothing else has run.
static SandboxTime allowed_within(const Allowance *allowance, Step step, Limit limit)
{
    const double given = allowance->given_seconds;
    if (given > 0) {
        return (SandboxTime){given, given, WALL_FACTOR * given};
    }
    if (!allowance->is_known[step]) {
        return allowance_ours();
    }
    const SandboxTime *used = &allowance->solution[step];
    const double processor = allowed(used->processor, limit);
    return (SandboxTime){processor, allowed(used->asleep, limit), WALL_FACTOR * processor};
}

double allowance_total(const Allowance *allowance)
{
    const SandboxTime step = allowed_within(allowance, STEP_RUNNING, FIRST);
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

SandboxTime allowance_of(const Allowance *allowance, Step step, int n, int is_again)
{
    SandboxTime time = allowed_within(allowance, step, is_again ? AGAIN : FIRST);
    const double left = left_in(allowance, 0) / n;
    time.processor = at_most(time.processor, left);
    time.asleep = at_most(time.asleep, left);
    if (allowance->deadline > 0) {
        time.wall = at_most(time.wall, allowance->deadline - seconds_now());
    }
    return time;
}

int allowance_is_asked(const Allowance *allowance, SandboxTime used)
{
    return allowance->yardstick != NULL && allowance->given_seconds == 0 &&
           allowance_left(allowance) > 0 && fmax(used.processor, used.asleep) >= FIRST.floor / 2;
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
