// What `make doctor` asks of OpenCL: is there a platform, a device, and does it see the structures
// that it shares with the host as the host does?
//
//     doctor_device platforms|list|device|layouts
//
// Prints one line of what was found, for list one a device. Ends with 0, or with 1 after one
// message on stderr, or with 2 where it was asked something else. doctor.sh compiles it, with what
// it needs of common/ and nothing else, so that it works where nothing is built. Read next:
// doctor_layouts.cl.
#include "cl_setup.h"
#include "doctor_structures.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define MAX_PLATFORMS 16

typedef struct Layout {
    const char *type;
    u32 n_bytes;      // of the structure
    u32 last_offset;  // of its last field, bytes
} Layout;

static const Layout layouts[] = {
#define LAYOUT(type, last) {#type, sizeof(type), offsetof(type, last)},
#include "doctor_layouts.h"
};

enum { N_LAYOUTS = sizeof layouts / sizeof *layouts };

// Prints every platform with its version. Returns 0, or -1 after one message.
static int platforms_print(void)
{
    cl_platform_id platforms[MAX_PLATFORMS];
    cl_uint n = 0;
    // Without any driver the loader reports an error instead of zero platforms.
    if (clGetPlatformIDs(MAX_PLATFORMS, platforms, &n) != CL_SUCCESS || n == 0) {
        return cl_setup_list(stdout);  // which says what is wrong
    }
    for (cl_uint i = 0; i < n && i < MAX_PLATFORMS; i++) {
        char name[128] = "unnamed platform", version[256] = "";
        clGetPlatformInfo(platforms[i], CL_PLATFORM_NAME, sizeof name, name, NULL);
        clGetPlatformInfo(platforms[i], CL_PLATFORM_VERSION, sizeof version, version, NULL);
        printf("%s%s (%s)", i > 0 ? ", " : "", name, version);
    }
    putchar('\n');
    return 0;
}

// Let the device write down its layouts. Returns 0, or -1 after one message.
//   d_found[2 * N_LAYOUTS]   out: size and offset of each, bytes
static int layouts_run(const ClSetup *setup, u32 *found)
{
    cl_program program =
        cl_setup_build(setup, "common/setup/doctor_layouts.cl", "-I kernels -I common/setup");
    if (program == NULL) {
        return -1;
    }
    cl_int error = CL_SUCCESS;
    cl_kernel kernel = clCreateKernel(program, "layouts", &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    const size_t n_bytes = 2 * N_LAYOUTS * sizeof *found, one = 1;
    cl_mem d_layouts = clCreateBuffer(setup->context, CL_MEM_WRITE_ONLY, n_bytes, NULL, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_layouts, &d_layouts));
    CL_CHECK(clEnqueueNDRangeKernel(setup->queue, kernel, 1, NULL, &one, NULL, 0, NULL, NULL));
    CL_CHECK(
        clEnqueueReadBuffer(setup->queue, d_layouts, CL_TRUE, 0, n_bytes, found, 0, NULL, NULL));
    CL_CHECK(clReleaseMemObject(d_layouts));
    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    return 0;
}

// Compare them with the host's. Returns 0, or -1 after one message.
static int layouts_compare(const ClSetup *setup)
{
    u32 found[2 * N_LAYOUTS] = {0};
    if (layouts_run(setup, found) != 0) {
        return -1;
    }
    for (int i = 0; i < N_LAYOUTS; i++) {
        if (found[2 * i] != layouts[i].n_bytes || found[2 * i + 1] != layouts[i].last_offset) {
            fprintf(stderr,
                    "%s: the device found %u bytes with the last field at %u, expected %u and %u "
                    "as on the host\n",
                    layouts[i].type, found[2 * i], found[2 * i + 1], layouts[i].n_bytes,
                    layouts[i].last_offset);
            return -1;
        }
    }
    printf("%d structures are the same on host and device\n", N_LAYOUTS);
    return 0;
}

int main(int argc, char **argv)
{
    const char *asked = argc == 2 ? argv[1] : "";
    if (strcmp(asked, "platforms") == 0) {
        return platforms_print() == 0 ? 0 : 1;
    }
    if (strcmp(asked, "list") == 0) {
        return cl_setup_list(stdout) == 0 ? 0 : 1;
    }
    const int is_device = strcmp(asked, "device") == 0;
    if (!is_device && strcmp(asked, "layouts") != 0) {
        fprintf(stderr, "usage: doctor_device platforms|list|device|layouts\n");
        return 2;
    }
    ClSetup setup;
    if (cl_setup_open(NULL, &setup) != 0) {
        return 1;
    }
    int result = 0;
    if (is_device) {
        size_t width, height;
        cl_setup_image_limit(&setup, &width, &height);
        printf("%s, images up to %zux%zu\n", setup.device_name, width, height);
    } else {
        result = layouts_compare(&setup);
    }
    cl_setup_close(&setup);
    return result == 0 ? 0 : 1;
}
