// Kernels compiled to native code by clang, as a library that dlopen() takes. Each is kept under a
// name made of all that it comes from, so what did not change is not compiled again.
//
// In the preprocessed text, functions named "kernel void" get an entry that takes their arguments'
// addresses, as the host does not know their types:
//
//     void entry_render(void **arguments) { render(*(int *)arguments[0], ...); }
//     constant uint parameters_render[] = {number of parameters, size and kind of each};
//     constant uint elements_render[] = {of a buffer, the size of what it is an array of, ...};
//     constant char names_render[] = "circles\0n_circles\0";
//
// Read next: kernels.h, which stands before each text.
#ifndef NATIVE_COMPILE_H
#define NATIVE_COMPILE_H

#include <stdio.h>

#define KERNEL_ENTRY "entry_"
#define KERNEL_PARAMETERS "parameters_"
#define KERNEL_ELEMENTS "elements_"
#define KERNEL_NAMES "names_"

// Words in the environment that clang gets besides, such as -fsanitize=address.
#define NATIVE_OPTIONS "NATIVE_OPTIONS"

// Compile a program's text, or find it compiled.
//   options   as clBuildProgram() has them
//   log       out: what the compiler said; owned by the caller
// Returns the library's path, owned by the caller, or NULL.
char *compile_kernels(const char *source, const char *options, char **log);

// Write the entries of the kernels in a preprocessed text. Returns how many there are, or -1 where
// one cannot be read.
int entries_write(const char *text, FILE *out);

#endif
