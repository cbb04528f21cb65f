#!/bin/bash
# Builds optimised, runs bench suites and leaves build/bench/<suite>.json with SVG plots beside it.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

usage() {
    cat <<'END'
usage: bench/run.sh [suite ...] [--quick] [--filter SUBSTRING] [--repetitions N] [--seeds N]
  Without a suite, all of them. --quick takes a look: two repetitions, and the files say so.
bench/run.sh against REV [suite|subject ...] [--quick] [--pairs N] [--seeds N] [--json FILE]
  Measures this revision against another one on the same core: bench/run.sh against --help.
bench/run.sh summary [--quick] [--core N] [--no-peers] [--out FOLDER]
  Measures all subjects with their peers, and writes docs/explanation/speed-against-error.md: bench/run.sh summary --help.
END
}

install() {
    # What is missing may be needed by a peer or for the plots only: the build will tell.
    if ! .ci/install-packages "$1"; then
        echo "bench/run.sh: going on with what is here" >&2
    fi
}

if [[ ${1:-} == against ]]; then
    install against
    exec /usr/bin/python3 -B bench/against/against.py "${@:2}"
fi

if [[ ${1:-} == summary ]]; then
    install bench
    exec /usr/bin/python3 -B bench/summary/summary.py "${@:2}"
fi

suites=()
options=()
while (($# > 0)); do
    case "$1" in
    --quick) options+=("$1") ;;
    --filter | --repetitions | --seeds)
        if (($# < 2)); then
            echo "bench/run.sh: $1 needs a value" >&2
            exit 2
        fi
        options+=("$1" "$2")
        shift
        ;;
    -h | --help)
        usage
        exit 0
        ;;
    -*)
        echo "bench/run.sh: unknown option $1" >&2
        usage >&2
        exit 2
        ;;
    *) suites+=("$1") ;;
    esac
    shift
done

install bench

build=build/release
cmake --preset release >/dev/null # problems go to stderr

mapfile -t known <"$build/bench/suites.txt"
if ((${#suites[@]} == 0)); then
    suites=("${known[@]}")
fi
for suite in "${suites[@]}"; do
    if ! printf '%s\n' "${known[@]}" | grep -qxF -- "$suite"; then
        echo "bench/run.sh: no suite '$suite'; there are: ${known[*]}" >&2
        exit 2
    fi
done

cmake --build "$build" --target "${suites[@]/#/bench_}"

git=$(git describe --always --dirty --exclude='*' 2>/dev/null || echo unknown)
out=build/bench
mkdir -p "$out"
failed=()
written=()
for suite in "${suites[@]}"; do
    json="$out/$suite.json"
    rm -f "$json" "$out/$suite"-*.svg # never yesterday's result beside today's
    if ! "$build/bench/bench_$suite" --out "$json" --git "$git" "${options[@]}"; then
        failed+=("$suite")
    fi
    if [[ -f $json ]]; then
        written+=("$json")
        if [[ -f bench/$suite/bars.py ]]; then
            echo
            /usr/bin/python3 "bench/$suite/bars.py" "$json"
        fi
    fi
done

echo
if ((${#written[@]} > 0)); then
    printf '%s\n' "${written[@]}"
    if /usr/bin/python3 -c 'import matplotlib' 2>/dev/null; then
        /usr/bin/python3 bench/plot.py "${written[@]}"
    else
        echo "no plots without matplotlib: apt-get install -y python3-matplotlib"
    fi
fi
if ((${#failed[@]} > 0)); then
    echo "bench/run.sh: failed: ${failed[*]}" >&2
    exit 1
fi
