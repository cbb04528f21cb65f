#!/usr/bin/env bash
# Stills of two hands that pass a needle, and a page that plays it: installs what is missing, builds, runs, says where they are.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

.ci/install-packages viewer

out=build/view
mkdir -p "$out"
cmake --preset release >"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }
cmake --build --preset release --target pass_needle viewer vbss_replay_page >>"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }
./build/release/examples/needle/pass_needle -k -s 1 -l "$out/pass.vbss"
./build/release/examples/viewer/viewer --replay "$out/pass.vbss" --png "$out" --every "${1:-0.5}"
./build/release/examples/replay_page/vbss-replay-page "$out/pass.vbss" -o "$out/pass.html"
