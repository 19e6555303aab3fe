// find_device: is there the device that the environment names, or any? Nothing of a student's is in
// this program: in a handout, which has no solution to run, it tells the machine's fault from an
// answer's (grader/run/device.h).
#include "cl_setup.h"

#include <stdlib.h>

int main(void)
{
    ClSetup setup;
    if (cl_setup_open(NULL, &setup) != 0) {
        return EXIT_FAILURE;
    }
    cl_setup_close(&setup);
    return EXIT_SUCCESS;
}
