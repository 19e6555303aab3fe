// Looking for the device in the sandbox, where drivers may see less than outside (see device.h).
#include "device.h"

#include "allowance.h"
#include "cl_setup.h"
#include "path.h"
#include "run_end.h"
#include "sandbox_system.h"
#include "workdir_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Run the program that looks for it, which is in the tree. NULL after one message.
static SandboxRun *start(const Workdir *workdir, SandboxTime time)
{
    char device[PATH_MAX];
    snprintf(device, sizeof device, CL_DEVICE_VARIABLE "=%s", workdir->device);
    const char *const argv[] = {"lib/find_device", NULL};
    const char *const environment[] = {device, NULL};
    const SandboxCommand command = workdir_command(workdir, argv, environment, time);
    return sandbox_start(&command);
}

int device_find(const Workdir *workdir)
{
    char from[PATH_MAX], to[PATH_MAX];
    path_make(from, "%s/probes/find_device", workdir->build);
    path_make(to, "%s/lib/find_device", workdir->tree);
    const SandboxTime time = allowance_ours();
    SandboxRun *run = copy_file(from, to) == 0 ? start(workdir, time) : NULL;
    if (run == NULL) {
        return -1;
    }
    SandboxResult result = sandbox_wait(run);
    char *end = result.outcome != SANDBOX_FAULT ? run_end_describe(&result, time) : NULL;
    const int is_there = result.outcome == SANDBOX_EXITED && result.exit_status == 0;
    if (!is_there) {
        // What the program says is one line; where it said nothing, how it ended.
        const char *why = result.output[0] != '\0' || end == NULL ? result.output : end;
        fprintf(stderr, "grade: nothing can be judged here: %.*s\n", (int)strcspn(why, "\n"), why);
        const char *vendors = getenv(VENDORS_VARIABLE);
        if (vendors != NULL && visible_vendors() == NULL) {
            fprintf(stderr,
                    "  " VENDORS_VARIABLE "=%s is not seen in the sandbox: put a link to the "
                    "driver's .icd file into /etc/OpenCL/vendors\n",
                    vendors);
        }
    }
    free(end);
    free(result.output);
    return is_there ? 0 : -1;
}
