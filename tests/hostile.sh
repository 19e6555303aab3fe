# shellcheck shell=sh disable=SC2154 # sourced, behind tests/tap.sh; used by the suites
# Variables of a grader's environment that must not reach a verdict: what a profile, another course or
# an attacker with a make target may have left there for drivers, compilers, libraries and tools.
#
#     . tests/hostile.sh

# hostile COMMAND...: run it with them.
hostile() {
    mkdir -p "$scratch/hostile/include"
    echo '#error somebody else wrote this header' >"$scratch/hostile/include/stdio.h"
    env POCL_MAX_PTHREAD_COUNT=-1 POCL_MAX_WORK_GROUP_SIZE=1 POCL_CPU_MAX_CU_COUNT=-1 POCL_DEVICES=none \
        POCL_WORK_GROUP_METHOD=none POCL_CACHE_DIR=/nowhere POCL_AFFINITY=1 POCL_DEBUG=all \
        OCL_ICD_VENDORS=/nowhere OCL_ICD_FILENAMES=none OCL_ICD_DEBUG=255 CUDA_VISIBLE_DEVICES= \
        COURSE_DEVICE=none COURSE_JOB=/nowhere COURSE_KERNELS=1 \
        GCC_EXEC_PREFIX=/nowhere/ COMPILER_PATH=/nowhere LIBRARY_PATH=/nowhere CFLAGS=-DNO LDFLAGS=-nostdlib \
        CPATH="$scratch/hostile/include" C_INCLUDE_PATH="$scratch/hostile/include" GCC_COLORS=always \
        DEPENDENCIES_OUTPUT="$scratch/hostile/written" \
        LD_LIBRARY_PATH="$scratch/hostile" LD_BIND_NOW=1 LD_DEBUG=unused \
        MALLOC_PERTURB_=165 MALLOC_CHECK_=3 GLIBC_TUNABLES=glibc.malloc.perturb=7 \
        ASAN_OPTIONS=exitcode=0:verbosity=3 UBSAN_OPTIONS=halt_on_error=1 OPENIMAGEIO_OPTIONS=threads=0 \
        LC_ALL=tr_TR.UTF-8 LANG=de_DE.UTF-8 LANGUAGE=de TZ=nowhere TERM=none COLUMNS=3 POSIXLY_CORRECT=1 \
        PARALLEL=--dry-run PARALLEL_SHELL=/bin/false SHELL=/bin/false CDPATH="$scratch" IFS=x \
        LIST=/nowhere WHO=/nowhere DUE=never NAMES=off ENV=/nowhere BASH_ENV=/nowhere GREP_OPTIONS=-v TAR_OPTIONS=--verbose XZ_OPT=--none OMP_NUM_THREADS=1 "$@"
}
