#!/usr/bin/env bash
# The tests, from a fresh machine to the verdict.
#
#   tests/run.sh                       default and slow suites: what continuous integration runs
#   tests/run.sh default               the default suite only, under 5 minutes
#   tests/run.sh slow                  the slow suite only
#   tests/run.sh soak [name] [seeds]   long runs, split into seeds; goes on where it was stopped
set -euo pipefail
cd "$(dirname "$0")/.."

suite=${1:-all}
case "$suite" in
all | default | slow | soak) ;;
*)
    sed -n '2,7s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac

.ci/install-packages tests

announce() {
    printf '\n== %s\n' "$1"
}

build() {
    cmake --preset "$1" -Wno-dev >"build/$1.log" 2>&1 || { cat "build/$1.log"; exit 1; }
    cmake --build --preset "$1" >>"build/$1.log" 2>&1 || { cat "build/$1.log"; exit 1; }
}

mkdir -p build
announce "build (gcc, optimised, warnings are errors)"
build default

if [ "$suite" = soak ]; then
    announce "soak"
    shift
    names=() seeds=()
    [ $# -lt 1 ] || names=("$1")
    [ $# -lt 2 ] || seeds=(--seeds "$2")
    exec python3 tests/soak.py --build build/default "${names[@]}" "${seeds[@]}"
fi

if [ "$suite" != default ]; then
    # Our own code under clang's sanitizers, which is also the build that clang must not warn about.
    for sanitizer in asan ubsan tsan; do
        announce "default suite under $sanitizer (clang)"
        build "$sanitizer"
        ctest --preset "$sanitizer" --label-exclude slow --parallel "$(nproc)" --progress
    done
    announce "slow suite"
    ctest --preset default --label-regex slow
fi
if [ "$suite" != slow ]; then
    announce "default suite"
    ctest --preset default --label-exclude slow --parallel "$(nproc)"
fi
