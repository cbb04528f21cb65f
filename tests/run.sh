#!/usr/bin/env bash
# The tests, from a fresh machine to the verdict.
#
#   tests/run.sh                       the default suite, in minutes
#   tests/run.sh thorough [part ...]   the bounded second part of continuous integration: tests/thorough.py
#   tests/run.sh all                   everything: default suite, sanitizers, masked processor, slow suite, full matrix
#   tests/run.sh slow                  the slow suite only
#   tests/run.sh coverage              which lines and branches of lib/ the tests reach
#   tests/run.sh costs [option ...]    CPU seconds of every test: tests/costs.py
#   tests/run.sh soak [name] [seeds]   long runs, split into seeds; goes on where it was stopped
#   tests/run.sh soak windows [seeds]  devices, built by MinGW and run by wine, where those are installed
set -euo pipefail
script=$(readlink -f "$0")
cd "$(dirname "$script")/.."

suite=${1:-default}
[ $# -eq 0 ] || shift
case "$suite" in
default | soak | costs) .ci/install-packages tests ;;
thorough | all | slow) .ci/install-packages thorough ;;
coverage) .ci/install-packages coverage ;;
*)
    sed -n '2,11s/^# \{0,1\}//p' "$script" >&2
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

slow_suite() {
    announce "slow suite"
    build default all slow_programs
    # The tables and what each canary was told, each line after the number of its test.
    ctest --preset default --label-regex slow --parallel "$(nproc)" --verbose
}

case "$suite" in
coverage)
    announce "default and slow suites, counted by gcov"
    build coverage all slow_programs
    ctest --preset coverage --parallel "$(nproc)"
    gcovr --root . --filter lib/ --branches build/coverage
    gcovr --root . --filter lib/ --print-summary build/coverage | tail -3
    exit 0
    ;;
soak)
    announce "soak"
    if [ "${1:-}" = windows ]; then
        exec python3 -B tests/device/windows.py . soak ${2:+"$2"}
    fi
    build default slow_programs
    exec python3 tests/soak.py --build build/default ${1:+"$1"} ${2:+--seeds "$2"}
    ;;
costs)
    announce "costs"
    build default all slow_programs
    exec python3 -B tests/costs.py build/default "$@"
    ;;
thorough)
    announce "build (gcc, optimised, warnings are errors)"
    build default
    exec python3 -B tests/thorough.py "$@"
    ;;
slow)
    slow_suite
    exit 0
    ;;
esac

announce "build (gcc, optimised, warnings are errors)"
build default
announce "default suite"
if [ "$suite" = all ]; then
    # A failure ends no part and no part after it: what is to be mended is known after one run.
    failed=()
    ctest --preset default --label-exclude slow --parallel "$(nproc)" || failed+=("default suite")
    # Our own code under clang's sanitizers, then hands with newer instructions hidden; then all that is slow.
    python3 -B tests/thorough.py asan tsan masked || failed+=("asan, tsan, masked")
    (slow_suite) || failed+=("slow suite")
    if [ ${#failed[@]} -gt 0 ]; then
        printf 'failed: %s\n' "${failed[@]}" >&2
        exit 1
    fi
    exit 0
fi
ctest --preset default --label-exclude slow --parallel "$(nproc)"
