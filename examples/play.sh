#!/usr/bin/env bash
# Two tools, a mouse, a window: installs what is missing, builds, and lets you play: throw (default), needle or stitch. Further
# words are the viewer's, such as --openhaptics.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

.ci/install-packages viewer

out=build/play
mkdir -p "$out"
cmake --preset release >"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }
cmake --build --preset release --target viewer >>"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }
log="$out/$(date +%Y%m%d-%H%M%S).vbss"
./build/release/examples/viewer/viewer --live "${1:-throw}" --log "$log" "${@:2}"
echo "What you did is in $log: look at it again with"
echo "    ./build/release/examples/viewer/viewer --replay $log"
