# shellcheck shell=sh
# How archives are made for those who get them: the same files at the same commit give the same bytes.

unset TAR_OPTIONS  # they come before those below

# settled ARGUMENT...: tar --create, with sorted names, one time and one owner.
settled() {
    tar --create --format=ustar --sort=name --mtime="@$(git log -1 --format=%ct)" --owner=0 --group=0 --numeric-owner \
        --mode=u=rwX,go=rX "$@"
}

# archive PARENT NAME FOLDER: make FOLDER/NAME.tar.gz of the folder PARENT/NAME, and FOLDER/NAME.txt, a list of its
# files: bytes and path, a line each.
archive() {
    mkdir -p "$3"
    settled --directory="$1" "$2" >"$1/archive.tar"
    gzip -n9 <"$1/archive.tar" >"$3/$2.tar.gz.new"
    rm "$1/archive.tar"
    mv "$3/$2.tar.gz.new" "$3/$2.tar.gz"
    (cd "$1/$2" && find . -type f -printf '%s %P\n' | LC_ALL=C sort -k 2) >"$3/$2.txt"
}
