# shellcheck shell=sh # sourced, by what opens windows
# A display that nobody sees, for programs that open a window.
#
#     . tests/display.sh
#     display_open || ...; trap display_close EXIT

display_server=

# Start Xvfb on a free display and set DISPLAY. Fails where there is no Xvfb.
display_open() {
    command -v Xvfb >/dev/null || return 1
    display_folder=$(mktemp -d "${TMPDIR:-/tmp}/display-XXXXXX")
    mkfifo "$display_folder/number"
    # It chooses a number itself, and says which once it is ready.
    Xvfb -displayfd 3 -screen 0 1600x1200x24 -nolisten tcp 3>"$display_folder/number" >/dev/null 2>&1 &
    display_server=$!
    read -r number <"$display_folder/number"
    rm -r "$display_folder"
    [ -n "$number" ] || return 1
    DISPLAY=:$number
    export DISPLAY
}

display_close() { [ -z "$display_server" ] || kill "$display_server" 2>/dev/null; }
