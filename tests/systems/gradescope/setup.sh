#!/bin/sh
# Lab @LAB@ on Gradescope: run once, as root, when the autograder's image is made.
#
# AUTOGRADER_ROOT is where Gradescope puts everything; the tests choose another place.
set -eu
exec "${AUTOGRADER_ROOT:-/autograder}/source/course/tests/systems/prepare.sh" @NN@
