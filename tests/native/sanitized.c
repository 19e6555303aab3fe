// Memory objects and launches under clang's address or memory sanitizer (native_cl.h): what
// `make memcheck` links in the place of plain.c.
//
// A memory object has its bytes in the middle of a slot of 256 GB of addresses, none of which may
// be touched but these: any index of 32 bits that is too large or negative ends there. If the
// program ends for a fault, a file says which array that was, which entry, and which work-item.
//
// Read next: launch.c.
#include "native_cl.h"

#include <fcntl.h>
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#include <sanitizer/msan_interface.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

// NATIVE_FAULT is from the makefile: the file that says where it was.

#define SLOT_BYTES ((size_t)1 << 38)
#define PAGE_BYTES ((size_t)4096)

// What lies this near below the frame of a launch was a kernel's stack.
enum { KERNEL_STACK_BYTES = 1 << 16 };

// Both sanitizers, of which the program has one: what the other's functions would do is nothing.
#pragma weak __asan_poison_memory_region
#pragma weak __asan_unpoison_memory_region
#pragma weak __asan_get_report_address
#pragma weak __msan_poison
#pragma weak __msan_unpoison

static void forbid(const void *bytes, size_t n_bytes)
{
    if (__asan_poison_memory_region != NULL) {
        __asan_poison_memory_region(bytes, n_bytes);
    }
}

static size_t whole_pages(size_t n_bytes)
{
    return (n_bytes + PAGE_BYTES - 1) / PAGE_BYTES * PAGE_BYTES;
}

// ---- Memory -------------------------------------------------------------------------------------

void *memory_new(size_t n_bytes)
{
    const size_t n_whole = whole_pages(n_bytes);
    char *slot =
        mmap(NULL, SLOT_BYTES, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    char *bytes = slot + SLOT_BYTES / 2;
    if (slot == MAP_FAILED || n_whole > SLOT_BYTES / 4 ||
        mprotect(bytes, n_whole, PROT_READ | PROT_WRITE) != 0) {
        return NULL;
    }
    forbid(bytes + n_bytes, n_whole - n_bytes);
    if (__msan_poison != NULL) {
        __msan_poison(bytes, n_bytes);
    }
    return bytes;
}

void memory_free(void *bytes, size_t n_bytes)
{
    if (bytes != NULL && __asan_unpoison_memory_region != NULL) {
        __asan_unpoison_memory_region(bytes, whole_pages(n_bytes));
    }
    if (bytes != NULL) {
        munmap((char *)bytes - SLOT_BYTES / 2, SLOT_BYTES);
    }
}

void memory_was_set(const void *bytes, size_t n_bytes)
{
    if (__msan_unpoison != NULL) {
        __msan_unpoison(bytes, n_bytes);
    }
}

// memcheck_passes.c looks for this line: from then on exit statuses may be the student's own.
void program_begins(void)
{
    puts("[from here on your kernels run]");
    fflush(stdout);
}

// The host's functions, which the sanitizer does not see, come to use this stack next.
__attribute__((noinline)) void launch_has_ended(void)
{
    char *here = __builtin_frame_address(0);
    memory_was_set(here - KERNEL_STACK_BYTES, KERNEL_STACK_BYTES);
}

// ---- Where it was -------------------------------------------------------------------------------

static const char *volatile touched;  // where that is no memory at all

static struct sigaction sanitizers_own;

static void note_address(int signal, siginfo_t *info, void *context)
{
    touched = info->si_addr;
    sanitizers_own.sa_sigaction(signal, info, context);
}

// The running kernel's argument whose slot an address is in: its number, or -1.
static int argument_at(const char *address, const char **bytes, size_t *n_bytes)
{
    for (cl_uint i = 0; kernel_running != NULL && i < kernel_running->parameters[0]; i++) {
        memcpy(bytes, kernel_running->values[i], sizeof *bytes);
        if (kernel_running->elements[1 + i] > 0 && *bytes != NULL &&
            address >= *bytes - SLOT_BYTES / 2 && address < *bytes + SLOT_BYTES / 2) {
            *n_bytes = mem_size_at(*bytes);
            return (int)i;
        }
    }
    return -1;
}

static void write_array(FILE *file, const char *address)
{
    const char *bytes, *name = kernel_running->names;
    size_t n_bytes;
    const int number = argument_at(address, &bytes, &n_bytes);
    if (number < 0) {
        return;
    }
    for (int i = 0; i < number; i++) {
        name += strlen(name) + 1;
    }
    const long n_element_bytes = (long)kernel_running->elements[1 + number];
    const long offset = address - bytes;
    const long entry = (offset < 0 ? offset - n_element_bytes + 1 : offset) / n_element_bytes;
    fprintf(file, "array %s %ld %ld\n", name, entry, (long)n_bytes / n_element_bytes);
}

// The program is about to end: "item 3 0", and of a memory object "array circles 4 4".
static void write_place(void)
{
    FILE *file = kernel_running != NULL ? fopen(NATIVE_FAULT, "w") : NULL;
    if (file == NULL) {
        return;
    }
    fprintf(file, "item %zu %zu\n", native_item(ASKS_GLOBAL_ID, 0), native_item(ASKS_GLOBAL_ID, 1));
    if (touched == NULL && __asan_get_report_address != NULL) {
        touched = __asan_get_report_address();
    }
    if (touched != NULL) {
        write_array(file, touched);
    }
    fclose(file);
}

__attribute__((constructor)) static void get_ready(void)
{
    struct sigaction action = {.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER};
    action.sa_sigaction = note_address;
    __sanitizer_set_death_callback(write_place);
    sigaction(SIGSEGV, &action, &sanitizers_own);
}
