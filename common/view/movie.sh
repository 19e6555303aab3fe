#!/bin/sh
# A film of a lab's scene: FOLDER/frame-00001.png and on, and FOLDER.mp4 where ffmpeg is installed.
#
#     common/view/movie.sh PROGRAM FOLDER [OPTION...]      OPTIONs are the program's; --path flies a path
set -eu

program=$1
folder=$2
shift 2

# The film before stays, until there is a new one: an option may be wrong.
mkdir -p "$folder.new"
rm -f "$folder.new"/frame-*.png
if ! "$program" --movie "$folder.new" "$@"; then
    rm -r "$folder.new"
    exit 1
fi
rm -rf "$folder" "$folder.mp4"
mv "$folder.new" "$folder"

if command -v ffmpeg >/dev/null; then
    # 25 poses a second (viewer.h). The usual players want sides of even length, and colours in 4:2:0.
    ffmpeg -loglevel error -y -framerate 25 -i "$folder/frame-%05d.png" \
        -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt yuv420p "$folder.mp4"
    echo "$folder.mp4"
else
    echo "$folder (install ffmpeg, and the next time there is a film, too)"
fi
