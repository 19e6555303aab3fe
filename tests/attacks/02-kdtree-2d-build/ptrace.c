// attack: takes over other processes, by ptrace and through /proc/PID/mem
// task: pack_leaf
// named: ptrace\(\)
#include <string.h>
#include <sys/ptrace.h>
#include <sys/uio.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    const int own = getpid();
    char path[64], text[64];
    for (int pid = own > 3000 ? own - 3000 : 1; pid < own + 50; pid++) {
        struct iovec here = {text, 1}, there = {(void *)0x400000, 1};
        // Process 1 of a sandbox of its own is part of the sandbox that the attack is in.
        if (pid == own || (pid == 1 && own < 100)) {
            continue;
        }
        snprintf(path, sizeof path, "/proc/%d/mem", pid);
        FILE *memory = fopen(path, "r+");
        if (memory != NULL) {
            printf("LEAK" "ED: opened the memory of %d\n", pid);
        }
        if (process_vm_readv(pid, &here, 1, &there, 1, 0) == 1) {
            printf("LEAK" "ED: read the memory of %d\n", pid);
        }
        if (ptrace(PTRACE_SEIZE, pid, 0, 0) == 0) {
            printf("LEAK" "ED: traces %d\n", pid);
        }
    }
    exit(7);
