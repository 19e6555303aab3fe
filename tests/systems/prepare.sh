#!/bin/sh
# Make a machine ready to grade one lab: install the packages that are missing, build the grader.
#
#     tests/systems/prepare.sh NN
#
# The bundles run it where their image is made. Run again, it finds everything done.
set -eu
cd "$(dirname "$0")/../.."
common/setup/install.sh demo
make -s -j"$(nproc)" lab-grader LAB="$1"
