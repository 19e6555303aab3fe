// A device, its context and its queue (see cl_setup.h).
//
// They are opened before the first buffer is made. Read next: cl_build.c, where programs are built.
#include "cl_setup.h"

#include "complain.h"
#include "number.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

// More than any machine of a course has; what is beyond is not listed.
#define MAX_PLATFORMS 16
#define MAX_DEVICES 64

typedef struct DeviceList {
    cl_device_id ids[MAX_DEVICES];
    char names[MAX_DEVICES][256];  // "platform: device"
    int n_devices;
} DeviceList;

// A device's name, cut off where it has more than n_bytes - 1.
static void device_name_read(cl_device_id device, char *name, size_t n_bytes)
{
    size_t n_whole = 0;
    char *whole = NULL;
    if (clGetDeviceInfo(device, CL_DEVICE_NAME, 0, NULL, &n_whole) == CL_SUCCESS) {
        whole = calloc(n_whole + 1, 1);
    }
    int is_read = whole != NULL &&
                  clGetDeviceInfo(device, CL_DEVICE_NAME, n_whole, whole, NULL) == CL_SUCCESS;
    snprintf(name, n_bytes, "%s", is_read ? whole : "unnamed device");
    free(whole);
}

static void devices_add_platform(DeviceList *list, cl_platform_id platform)
{
    cl_device_id ids[MAX_DEVICES];
    cl_uint n_ids = 0;
    // A platform without devices reports an error; the others may still have some.
    if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, MAX_DEVICES, ids, &n_ids) != CL_SUCCESS) {
        return;
    }

    char platform_name[120] = "unnamed platform";
    clGetPlatformInfo(platform, CL_PLATFORM_NAME, sizeof platform_name, platform_name, NULL);
    for (cl_uint i = 0; i < n_ids && list->n_devices < MAX_DEVICES; i++) {
        char device_name[120];
        device_name_read(ids[i], device_name, sizeof device_name);
        snprintf(list->names[list->n_devices], sizeof list->names[0], "%s: %s", platform_name,
                 device_name);
        list->ids[list->n_devices++] = ids[i];
    }
}

// Find every device, platform by platform. Returns 0, or -1 after one message when there is none.
static int devices_find(DeviceList *list)
{
    cl_platform_id platforms[MAX_PLATFORMS];
    cl_uint n_platforms = 0;
    list->n_devices = 0;
    // Without any driver the loader reports an error instead of zero platforms.
    if (clGetPlatformIDs(MAX_PLATFORMS, platforms, &n_platforms) != CL_SUCCESS) {
        n_platforms = 0;
    }
    if (n_platforms > MAX_PLATFORMS) {
        n_platforms = MAX_PLATFORMS;
    }
    for (cl_uint i = 0; i < n_platforms; i++) {
        devices_add_platform(list, platforms[i]);
    }

    if (list->n_devices > 0) {
        return 0;
    }
    const char *vendors = getenv("OCL_ICD_VENDORS"), *pocl_devices = getenv("POCL_DEVICES");
    if (n_platforms == 0 && vendors != NULL) {
        complain("OpenCL: found no platform in OCL_ICD_VENDORS=%s; unset it to take the system's "
                 "drivers; make doctor says more",
                 vendors);
    } else if (n_platforms == 0) {
        complain("OpenCL: found no platform; PoCL runs on every CPU: make doctor names the command "
                 "that brings it");
    } else if (pocl_devices != NULL) {
        complain("OpenCL: found a platform but no device; does POCL_DEVICES=%s name one that PoCL "
                 "does not have here? Unset it; make doctor says more",
                 pocl_devices);
    } else {
        complain("OpenCL: found a platform but no device; PoCL needs a cache folder that it "
                 "can write (POCL_CACHE_DIR, or ~/.cache/pocl); make doctor says more");
    }
    return -1;
}

static int contains_in_any_case(const char *text, const char *part)
{
    size_t part_length = strlen(part);
    for (; *text != '\0'; text++) {
        if (strncasecmp(text, part, part_length) == 0) {
            return 1;
        }
    }
    return 0;
}

// The position in the list of the device that a user named, or -1 after one message.
static int devices_choose(const DeviceList *list, const char *choice)
{
    if (choice[strspn(choice, "0123456789")] == '\0') {
        int64_t number;
        if (number_read_integer(choice, 0, list->n_devices - 1, &number) == 0) {
            return (int)number;
        }
    } else {
        for (int i = 0; i < list->n_devices; i++) {
            if (contains_in_any_case(list->names[i], choice)) {
                return i;
            }
        }
    }
    char known[4096] = "";
    for (int i = 0; i < list->n_devices; i++) {
        const size_t length = strlen(known);
        snprintf(known + length, sizeof known - length, "%s %d \"%s\"", i > 0 ? "," : "", i,
                 list->names[i]);
    }
    complain("OpenCL: found no device \"%s\", expected a number or a part of a name from:%s",
             choice, known);
    return -1;
}

int cl_setup_open(const char *device_choice, ClSetup *setup)
{
    *setup = (ClSetup){0};
    DeviceList list;
    if (devices_find(&list) != 0) {
        return -1;
    }

    if (device_choice == NULL) {
        device_choice = getenv(CL_DEVICE_VARIABLE);
        device_choice = device_choice != NULL && device_choice[0] != '\0' ? device_choice : "0";
    }
    int chosen = devices_choose(&list, device_choice);
    if (chosen < 0) {
        return -1;
    }
    cl_device_id device = list.ids[chosen];

    cl_bool has_images = CL_FALSE;
    CL_CHECK(
        clGetDeviceInfo(device, CL_DEVICE_IMAGE_SUPPORT, sizeof has_images, &has_images, NULL));
    if (!has_images) {
        complain("OpenCL: device %d \"%s\" has no images; choose another with --device", chosen,
                 list.names[chosen]);
        return -1;
    }

    cl_int error = CL_SUCCESS;
    setup->device = device;
    setup->context = clCreateContext(NULL, 1, &device, NULL, NULL, &error);
    CL_CHECK_CREATED(error, clCreateContext);
    setup->queue = clCreateCommandQueue(setup->context, device, 0, &error);
    CL_CHECK_CREATED(error, clCreateCommandQueue);
    device_name_read(device, setup->device_name, sizeof setup->device_name);
    return 0;
}

void cl_setup_close(ClSetup *setup)
{
    if (setup->queue != NULL) {
        CL_CHECK(clReleaseCommandQueue(setup->queue));
    }
    if (setup->context != NULL) {
        CL_CHECK(clReleaseContext(setup->context));
    }
    *setup = (ClSetup){0};
}

int cl_setup_list(FILE *out)
{
    DeviceList list;
    if (devices_find(&list) != 0) {
        return -1;
    }
    for (int i = 0; i < list.n_devices; i++) {
        fprintf(out, "%d  %s\n", i, list.names[i]);
    }
    return 0;
}

void cl_setup_image_limit(const ClSetup *setup, size_t *max_width, size_t *max_height)
{
    CL_CHECK(clGetDeviceInfo(setup->device, CL_DEVICE_IMAGE2D_MAX_WIDTH, sizeof *max_width,
                             max_width, NULL));
    CL_CHECK(clGetDeviceInfo(setup->device, CL_DEVICE_IMAGE2D_MAX_HEIGHT, sizeof *max_height,
                             max_height, NULL));
}
