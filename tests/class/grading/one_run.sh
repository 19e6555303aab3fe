# shellcheck shell=sh
# One run at a time in a class's folder, which a signal ends at once: for grade_class.sh and copies.sh,
# which have a function `die`.

# folder_hold FOLDER PROGRAM: hold FOLDER/lock, as do all processes of this run, so that it is free when the
# last of them has ended. The file says who holds it.
folder_hold() {
    : >>"$1/lock" || die "$1: cannot be written"
    exec 9<"$1/lock"
    flock --wait 20 9 ||
        die "$1: another run is at work there ($(head -n 1 "$1/lock")): wait until it has ended, or end it with kill"
    echo "$2, process $$ on $(uname -n)" >"$1/lock"
}

# attend COMMAND...: run it so that a signal is heard while it runs. A shell hears none while it waits for a
# command in front.
attended=
attend() {
    "$@" <&3 3<&- &
    attended=$!
    wait "$attended"
    attended_status=$?
    attended=
    return $attended_status
} 3<&0

# stop: what a signal does. The command ends, and with it all that it has started; what this run leaves is
# cleared away by the trap on EXIT.
stop() {
    trap '' INT TERM HUP PIPE
    if [ -n "$attended" ]; then
        kill -KILL "$attended"
        wait "$attended"
    fi 2>/dev/null
    stop_waits
    die "ended by a signal; the same command goes on where this one stopped"
}
stop_waits() { :; }
