#!/usr/bin/env bash
# The tests, from a fresh machine to the verdict.
#
#   tests/run.sh                       default and slow suites: what continuous integration runs
#   tests/run.sh default               the default suite only, under 5 minutes
#   tests/run.sh slow                  the slow suite only
#   tests/run.sh coverage              which lines and branches of lib/ the tests reach
#   tests/run.sh soak [name] [seeds]   long runs, split into seeds; goes on where it was stopped
#   tests/run.sh soak windows [seeds]  devices, built by MinGW and run by wine, where those are installed
set -euo pipefail
script=$(readlink -f "$0")
cd "$(dirname "$script")/.."

suite=${1:-all}
case "$suite" in
all | default | slow | soak) .ci/install-packages tests ;;
coverage) .ci/install-packages coverage ;;
*)
    sed -n '2,9s/^# \{0,1\}//p' "$script" >&2
    exit 2
    ;;
esac

announce() {
    printf '\n== %s\n' "$1"
}

# Configures and builds a preset, or the targets of it that follow; what that prints stays in a file unless it fails.
build() {
    mkdir -p build
    cmake --preset "$1" >"build/$1.log" 2>&1 || { cat "build/$1.log"; exit 1; }
    cmake --build --preset "$1" ${2:+--target "${@:2}"} >>"build/$1.log" 2>&1 || { cat "build/$1.log"; exit 1; }
}

if [ "$suite" = coverage ]; then
    announce "default and slow suites, counted by gcov"
    build coverage
    ctest --preset coverage --parallel "$(nproc)"
    gcovr --root . --filter lib/ --branches build/coverage
    gcovr --root . --filter lib/ --print-summary build/coverage | tail -3
    exit 0
fi

if [ "$suite ${2:-}" = "soak windows" ]; then
    announce "soak windows"
    exec python3 -B tests/device/windows.py . soak ${3:+"$3"}
fi

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

if [ "$suite" != slow ]; then
    announce "default suite"
    ctest --preset default --label-exclude slow --parallel "$(nproc)"
fi
if [ "$suite" != default ]; then
    # Our own code under clang's sanitizers, which is also the build that clang must not warn about.
    # The properties see other cases each time.
    seed=2 only=() targets=()
    for sanitizer in asan tsan; do
        if [ "$sanitizer" = tsan ]; then # nowhere else is more than one thread
            only=(--tests-regex '^(base|device|trainer|examples\.trainer)')
            targets=(test_base test_device test_trainer trainer pass_needle surgeon)
        fi
        announce "default suite under $sanitizer (clang), properties with seed $seed"
        build "$sanitizer" "${targets[@]}"
        VBSS_PROPERTY_SEED=$seed ctest --preset "$sanitizer" --label-exclude slow \
            "${only[@]}" --parallel "$(nproc)" --progress
        seed=$((seed + 1))
    done
    announce "slow suite"
    # The tables and what each canary was told, each line after the number of its test.
    ctest --preset default --label-regex slow --parallel "$(nproc)" --verbose
fi
