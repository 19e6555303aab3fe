// A device without images, for the tests: LD_PRELOAD=build/tests/no_images.so before a program lets
// every OpenCL device say that it has none. All other questions reach the driver.
#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 120
#endif
#include <CL/cl.h>
#include <dlfcn.h>
#include <string.h>

typedef cl_int GetDeviceInfo(cl_device_id device, cl_device_info question, size_t n_bytes,
                             void *answer, size_t *n_answer_bytes);

cl_int clGetDeviceInfo(cl_device_id device, cl_device_info question, size_t n_bytes, void *answer,
                       size_t *n_answer_bytes)
{
    // POSIX has dlsym() return functions as void *; C11 has no cast for that.
    void *symbol = dlsym(RTLD_NEXT, "clGetDeviceInfo");
    GetDeviceInfo *driver;
    memcpy(&driver, &symbol, sizeof driver);
    const cl_int error = driver(device, question, n_bytes, answer, n_answer_bytes);
    if (error == CL_SUCCESS && question == CL_DEVICE_IMAGE_SUPPORT && answer != NULL) {
        *(cl_bool *)answer = CL_FALSE;
    }
    return error;
}
