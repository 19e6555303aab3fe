# shellcheck shell=sh
# What an instructor chooses for Gradescope. run_autograder sources this file, and so does bundle.sh.
#
#     HIDE       "", after_due_date or after_published
#     THROTTLE   "", or a number from 1 to 999 and hour, day or week: 5/day

# check_options: are both such? Else 2, after one message on stderr.
check_options() {
    case ${HIDE:-} in
    '' | after_due_date | after_published) ;;
    *)
        printf '%s\n' "HIDE: found \"$HIDE\", expected after_due_date or after_published" >&2
        return 2
        ;;
    esac
    case ${THROTTLE:-} in
    '' | [1-9]/hour | [1-9]/day | [1-9]/week) ;;
    [1-9][0-9]/hour | [1-9][0-9]/day | [1-9][0-9]/week) ;;
    [1-9][0-9][0-9]/hour | [1-9][0-9][0-9]/day | [1-9][0-9][0-9]/week) ;;
    *)
        printf '%s\n' "THROTTLE: found \"$THROTTLE\", expected a number and hour, day or week, such as 5/day" >&2
        return 2
        ;;
    esac
}

# earlier_result METADATA FILTER: print the result in place of one that must not be graded (FILTER, throttle.jq). Returns 1,
# with nothing printed, if it may be graded, or if the file says nothing about it.
earlier_result() {
    if [ ! -r "$1" ]; then
        echo "THROTTLE: $1 cannot be read: graded" >&2
        return 1
    fi
    instead=$(jq -c --argjson most "${THROTTLE%/*}" --arg window "${THROTTLE#*/}" -f "$2" "$1") || {
        echo "THROTTLE: $1 is not what Gradescope documents: graded" >&2
        return 1
    }
    [ -n "$instead" ] && printf '%s\n' "$instead"
}
