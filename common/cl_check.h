// Checking OpenCL calls: a failed call ends the program and says where, which call and which error.
//
//     CL_CHECK(clFinish(queue));
//     cl_mem d_circles = clCreateBuffer(context, flags, n_bytes, h_circles, &error);
//     CL_CHECK_CREATED(error, clCreateBuffer);
//
// It stands around every OpenCL call of a lab. Read next: cl_setup.h.
#ifndef COMMON_CL_CHECK_H
#define COMMON_CL_CHECK_H

#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 120
#endif
#include <CL/cl.h>

// Evaluate an OpenCL call that returns its status. On failure print
// "file:line: call: CL_ERROR_NAME (number)" to stderr and end the program with EXIT_FAILURE.
#define CL_CHECK(call) cl_check((call), __FILE__, __LINE__, #call)

// The same for calls that return an object and leave the status in a variable.
#define CL_CHECK_CREATED(error, call) cl_check((error), __FILE__, __LINE__, #call)

// The name of an OpenCL status, "CL_INVALID_ARG_SIZE" for -51; "unknown OpenCL error" for others.
const char *cl_error_name(cl_int error);

// What CL_CHECK calls. Returns only when error is CL_SUCCESS.
void cl_check(cl_int error, const char *file, int line, const char *call);

#endif
