#!/bin/sh
# attack: each of its runs computes for nearly as long as is allowed and then sleeps for as long, until the host ends the grader: "not graded" costs no attempt
# limit: 1
# score: 0
# named: all runs together
cat >>kdtree2d_build.c <<'C'
#include <time.h>
#include <unistd.h>
__attribute__((constructor)) static void tire(void)
{
    while (clock() < CLOCKS_PER_SEC * 8 / 10) {
    }
    sleep(60);
}
C
