// How much memory a piece of work has asked for at most. Counted, and not read from the system
// (ru_maxrss, VmHWM): the counts are exact and the same on every machine, for small builds too,
// where the system counts whole pages, and what an earlier build has given back but malloc() has
// kept. They are what is asked for; of an array with room to grow a part may never be touched, and
// then takes no page.
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
