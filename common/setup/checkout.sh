#!/bin/sh
# Does git read this folder, and know which files are the course's? For whatever packs them.
#
#     common/setup/checkout.sh      in the course's top folder
#
# Says nothing and ends with 0 if so. If not, it ends with 1 and says on stdout why, and below that what to run.
set -u
LC_ALL=C
export LC_ALL
. common/setup/advice.sh

if ! has git; then
    echo "git is not installed"
    printf '    run: %s\n' "$(brings_tool git git)"
    exit 1
fi
if words=$(git log -1 --format=%ct 2>&1); then exit 0; fi
case $words in
*"dubious ownership"*)
    echo "git does not read this checkout, because another user owns it (\"dubious ownership\")"
    # git names the folder as it wants it.
    printf '    run: %s\n' "$(echo "$words" | sed -n 's/^[ 	]*\(git config .*\)/\1/p')"
    ;;
*"not a git repository"*) echo "here is no git checkout, as git clone makes one" ;;
*) echo "git cannot read this checkout: $(echo "$words" | head -n 1)" ;;
esac
exit 1
