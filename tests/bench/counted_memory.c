// Counting memory (see counted_memory.h).
//
// Read next: case_build.c.
#include "counted_memory.h"

#include "complain.h"

#include <stdlib.h>

// What the linker makes of them: calls come to __wrap_NAME(), and __real_NAME() is the library's.
void *__real_malloc(size_t n_bytes);
void *__real_calloc(size_t n, size_t n_bytes);
void *__real_realloc(void *block, size_t n_bytes);
void __real_free(void *block);
void *__wrap_malloc(size_t n_bytes);
void *__wrap_calloc(size_t n, size_t n_bytes);
void *__wrap_realloc(void *block, size_t n_bytes);
void __wrap_free(void *block);

// The blocks in use that were made while counting; NULL where there is room for one.
static struct {
    void *block;
    size_t n_bytes;
} blocks[COUNTED_BLOCKS];
static int counting;
static size_t n_in_use, n_most;

// The place of a block, or of NULL: a free one. Returns COUNTED_BLOCKS where there is none.
static int place_of(const void *block)
{
    int place = 0;
    while (place < COUNTED_BLOCKS && blocks[place].block != block) {
        place++;
    }
    return place;
}

static void forget(const void *block)
{
    const int place = place_of(block);
    if (block != NULL && place < COUNTED_BLOCKS) {
        n_in_use -= blocks[place].n_bytes;
        blocks[place].block = NULL;
    }
}

static void *note(void *block, size_t n_bytes)
{
    if (block == NULL || !counting) {
        return block;
    }
    const int place = place_of(NULL);
    if (place == COUNTED_BLOCKS) {
        counting = 0;
        complain("counted memory: more than %d blocks", COUNTED_BLOCKS);
        exit(EXIT_FAILURE);
    }
    blocks[place].block = block;
    blocks[place].n_bytes = n_bytes;
    n_in_use += n_bytes;
    n_most = n_in_use > n_most ? n_in_use : n_most;
    return block;
}

void *__wrap_malloc(size_t n_bytes)
{
    return note(__real_malloc(n_bytes), n_bytes);
}

void *__wrap_calloc(size_t n, size_t n_bytes)
{
    return note(__real_calloc(n, n_bytes), n * n_bytes);
}

void *__wrap_realloc(void *block, size_t n_bytes)
{
    void *moved = __real_realloc(block, n_bytes);
    if (moved != NULL) {
        forget(block);
    }
    return note(moved, n_bytes);
}

void __wrap_free(void *block)
{
    forget(block);
    __real_free(block);
}

void memory_count_begin(void)
{
    for (int place = 0; place < COUNTED_BLOCKS; place++) {
        blocks[place].block = NULL;
    }
    n_in_use = n_most = 0;
    counting = 1;
}

size_t memory_count_end(void)
{
    counting = 0;
    return n_most;
}
