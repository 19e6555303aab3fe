// Process 1's program (see sandbox_init.h), as the compiler made it, inside this one: so it need
// not be looked for, and nobody can have changed the file.
#include "sandbox_init.h"

#include <errno.h>
#include <stdint.h>
#include <sys/mman.h>
#include <unistd.h>

// SANDBOX_INIT is the path of what sandbox_init_tool.c was compiled to.
__asm__(".pushsection .rodata\n"
        "init_program: .incbin \"" SANDBOX_INIT "\"\n"
        "init_program_end: .balign 8\n"
        "init_program_bytes: .quad init_program_end - init_program\n"
        ".popsection\n");
extern const char init_program[];
extern const int64_t init_program_bytes;

int init_open(void)
{
    const int descriptor = memfd_create("sandbox_init", 0);
    if (descriptor < 0) {
        return -1;
    }
    const size_t n_bytes = (size_t)init_program_bytes;
    if (write(descriptor, init_program, n_bytes) == init_program_bytes &&
        lseek(descriptor, 0, SEEK_SET) == 0) {
        return descriptor;
    }
    const int fault = errno;
    close(descriptor);
    errno = fault;
    return -1;
}
