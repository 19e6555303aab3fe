// Standard input, output and error (see standard_streams.h).
//
// Read next: stats.c.
#include "standard_streams.h"

#include "complain.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

void standard_streams_begin(void)
{
    // In rising order: open() takes the lowest number that is free.
    for (int descriptor = 0; descriptor <= STDERR_FILENO; descriptor++) {
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) {
            // The wrong way round, so that reading or writing is a fault here as it was there.
            open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

int standard_output_check(void)
{
    const int result = fflush(stdout);
    const int fault = result != 0 ? errno : EIO;
    if (result == 0 && !ferror(stdout)) {
        return 0;
    }
    complain("standard output: cannot be written: %s", strerror(fault));
    return -1;
}
