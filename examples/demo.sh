#!/usr/bin/env bash
# The scripted surgeon performs the whole task once: installs what is missing, builds, runs, says where film, stills, report,
# replay page and log are. Exits 0 only if the task was completed and all of them could be made. (The rest: examples/gallery.sh.)
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

out=build/demo
build_log="$out/build.log"
mkdir -p "$out/stages"
rm -f "$out"/frame-*.png "$out"/stages/*.png "$out"/task.* "$out"/replay.html "$out"/report.html "$out"/details.txt

.ci/install-packages demo

# Reads what ninja prints, and shows how much of the build is done: "[17/210] ...".
show_build() {
    local line percent left spent width='##############################' last=-10
    while IFS= read -r line; do
        printf '%s\n' "$line" >>"$build_log"
        [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
        percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2]))
        spent=$SECONDS
        left=$((percent > 2 ? spent * (100 - percent) / percent : 0))
        if [ -t 1 ]; then
            printf '\r[%-30s] %3d %%  %d:%02d left   building' "${width:0:percent*30/100}" "$percent" $((left / 60)) $((left % 60))
        elif [ $((spent - last)) -ge 10 ]; then
            printf '[%-30s] %3d %%  %d:%02d left   building\n' "${width:0:percent*30/100}" "$percent" $((left / 60)) $((left % 60))
            last=$spent
        fi
    done
    [ ! -t 1 ] || printf '\r%78s\r' ''
}

echo "Part 1 of 2: the build"
SECONDS=0
cmake --preset release >"$build_log" 2>&1 || { cat "$build_log"; exit 1; }
cmake --build --preset release --target demo 2>&1 | show_build || { cat "$build_log"; exit 1; }

echo "Part 2 of 2: the performance"
exec ./build/release/examples/demo/demo "$out"
