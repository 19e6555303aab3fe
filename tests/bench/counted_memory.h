// How much memory a piece of work has asked for at most, at one moment. Counted, and not read from
// the system (ru_maxrss, VmHWM): the count is exact and the same on every machine, for small builds
// too, where the system knows whole pages only, and of them also those that an earlier build has
// given back and malloc() has kept. What is asked for is more than what is resident: a part of an
// array that has made room to grow may never be touched, and then takes no page.
//
// A program that uses it is linked with MEMORY_COUNTING (bench.mk), by which malloc(), calloc(),
// realloc() and free() of all its objects, though not those of libraries, lead here.
#ifndef BENCH_COUNTED_MEMORY_H
#define BENCH_COUNTED_MEMORY_H

#include <stddef.h>

// Count from here on: blocks that are made after it, in this thread. At most COUNTED_BLOCKS of them
// may be in use at once, or the program ends with a message.
#define COUNTED_BLOCKS 64
void memory_count_begin(void);

// Stop counting. Returns the most bytes that were in use at one moment. A block that realloc()
// makes larger counts once: whether old and new are there together is up to the library.
size_t memory_count_end(void);

#endif
