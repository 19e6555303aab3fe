# shellcheck shell=sh # sourced, by what opens windows
# A display that nobody sees, for programs that open a window.
#
#     . tests/display.sh
#     display_open || ...; trap display_close EXIT

display_server=
display_width=1600 display_height=1200

# Start Xvfb on a free display and set DISPLAY. Fails where there is no Xvfb.
display_open() {
    command -v Xvfb >/dev/null || return 1
    display_folder=$(mktemp -d "${TMPDIR:-/tmp}/display-XXXXXX")
    mkfifo "$display_folder/number"
    # It chooses a number itself, and says which once it is ready.
    Xvfb -displayfd 3 -screen 0 ${display_width}x${display_height}x24 -nolisten tcp 3>"$display_folder/number" >/dev/null 2>&1 &
    display_server=$!
    read -r number <"$display_folder/number"
    rm -r "$display_folder"
    [ -n "$number" ] || return 1
    DISPLAY=:$number
    export DISPLAY
}

display_close() { [ -z "$display_server" ] || kill "$display_server" 2>/dev/null; }

# display_save FILE.png: what is on the screen.
display_save() {
    ffmpeg -loglevel error -f x11grab -video_size ${display_width}x$display_height -i "$DISPLAY" -frames:v 1 -y "$1" </dev/null
}

# png_number FILE.png BYTE: the number of four bytes that stands there.
png_number() { od -An -t u1 -j "$2" -N 4 "$1" | { read -r a b c d && echo $(((a * 256 + b) * 65536 + c * 256 + d)); }; }

# display_middle FILE.png: "left top" of a window of this picture's size, which stands in the middle.
display_middle() {
    echo $(((display_width - $(png_number "$1" 16)) / 2)) $(((display_height - $(png_number "$1" 20)) / 2))
}
