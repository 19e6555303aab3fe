#!/bin/sh
# Print the name of a clang that makes WebAssembly with a C library: it needs lld, wasi-libc and
# libclang-rt-dev-wasm32. Status 1 where none does.
scratch=$(mktemp -d "${TMPDIR:-/tmp}/compiler-XXXXXX")
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
printf '%s\n' '#include <stdlib.h>' 'int main(void) { return atoi("0"); }' >"$scratch/empty.c"
for name in clang clang-19; do
    if "$name" --target=wasm32-wasi --sysroot=/usr "$scratch/empty.c" -o "$scratch/empty.wasm" 2>/dev/null; then
        echo "$name"
        exit 0
    fi
done
exit 1
