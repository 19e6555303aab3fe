#!/bin/sh
# Print the name of a Chromium that is installed; status 1 where none is.
for name in chromium chromium-browser google-chrome; do
    if command -v "$name"; then exit 0; fi
done
exit 1
