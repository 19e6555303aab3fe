# shellcheck shell=sh
# How many processes a bundle uses, and how long a submission may compute. Its scripts source this file.
#
#     JOBS        processes that build the grader, from 1 to 512
#     TIME_LIMIT  seconds of processor time that a submission may use, from 1 to 3600: grade's --time-limit
#
# Both come from the environment, and may be empty. What was chosen is said, and why.

# whole NAME TEXT MOST: is it a whole number from 1 to MOST? Else 2, after one message on stderr.
whole() {
    case $2 in
    *[!0-9]* | 0* | ??????*) ;;
    *) [ "$2" -gt "$3" ] || return 0 ;;
    esac
    printf '%s\n' "$1: found \"$2\", expected a whole number from 1 to $3" >&2
    return 2
}

# first FILE...: the first line of the first of these files that can be read, or nothing.
first() {
    for file; do
        if [ -r "$file" ]; then
            head -n 1 "$file"
            return
        fi
    done
}

# fewer NUMBER WHY: not more processes than that, but one. What is no number is no limit.
fewer() {
    case $1 in
    '' | *[!0-9]* | ??????*) return ;;
    0) set -- 1 "$2" ;;
    esac
    [ "$JOBS" -le "$1" ] || { JOBS=$1 why=$2; }
}

# As many processes as there are processors: those that this container may use, of which a quota may be
# a half, and not those of the machine. Fewer where memory or processes are few: a compiler takes up to
# 350 MB, and with make and the shell four processes.
count_processors() {
    cgroup=${CGROUP_ROOT:-/sys/fs/cgroup}
    # nproc believes OpenMP's variables; they are about another program's threads.
    JOBS=$(env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc)
    why="processors here: $JOBS"
    # "50000 100000" is half a processor; no quota is "max 100000", or -1 in the older form.
    quota=$(first "$cgroup/cpu.max")
    [ -n "$quota" ] || quota="$(first "$cgroup/cpu/cpu.cfs_quota_us") $(first "$cgroup/cpu/cpu.cfs_period_us")"
    case $quota in
    [1-9]*' '[1-9]*)
        percent=$((${quota% *} * 100 / ${quota#* }))
        fewer $((percent / 100)) "$percent% of a processor here"
        ;;
    esac
    bytes=$(first "$cgroup/memory.max" "$cgroup/memory/memory.limit_in_bytes")
    megabytes=${bytes%??????}
    case $megabytes in
    '' | *[!0-9]*) ;;
    *) fewer $((megabytes / 350)) "$megabytes MB of memory here" ;;
    esac
    processes=$(awk '/^Max processes/ { print $3 }' "${LIMITS_FILE:-/proc/self/limits}")
    case $processes in
    '' | *[!0-9]*) ;;
    *) fewer $((processes / 25)) "at most $processes processes here" ;;
    esac
}

# choose_jobs: set JOBS, and say why. Returns 2 after one message on stderr where it is no number.
choose_jobs() {
    if [ -n "${JOBS:-}" ]; then
        whole JOBS "$JOBS" 512 || return
        why="JOBS"
    else
        count_processors
    fi
    # Left alone, OpenImageIO starts a thread for each processor of the machine.
    OPENIMAGEIO_THREADS=$JOBS
    export JOBS OPENIMAGEIO_THREADS
    echo "Processes: $JOBS ($why)"
}

# choose_limits: choose_jobs, and set `limit`, options of grade, and say what it is. Returns as that does.
choose_limits() {
    choose_jobs || return
    limit=
    if [ -z "${TIME_LIMIT:-}" ]; then
        echo "Time limit of a submission: the default"
        return
    fi
    whole TIME_LIMIT "$TIME_LIMIT" 3600 || return
    # shellcheck disable=SC2034 # for the script that sources this
    limit="--time-limit $TIME_LIMIT"
    echo "Time limit of a submission: $TIME_LIMIT s of processor time (TIME_LIMIT)"
}
