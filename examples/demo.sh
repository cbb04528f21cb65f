#!/usr/bin/env bash
# Shows what the library can do: installs what is missing, builds, runs, says where the results are. Exits 0 if the scripted
# surgeon completed the task.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

.ci/install-packages demo

out=build/demo
mkdir -p "$out/knots" "$out/throws" "$out/drain" "$out/needle" "$out/surgeon/stages" "$out/report"
rm -f "$out/surgeon/complete"
echo "== building (release)"
cmake --preset release >"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }
cmake --build --preset release --target embed_c embed_cpp first_throw knot_gallery drain_gallery pass_needle surgeon vbss_report viewer vbss_replay_page >>"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }

{
    echo "== embedding in C"
    ./build/release/examples/embed_c
    echo "== embedding in C++"
    ./build/release/examples/embed_cpp
    echo "== from a device's sample to a certified throw: two scripted hands tie"
    ./build/release/examples/throw/first_throw -o "$out/throws" -s 2 single double surgeons
    echo "== tying knots, and what the detector says of them"
    ./build/release/examples/knots/knot_gallery "$out/knots"
    echo "== the drain: poked, pinched, shut, opened, pushed in, torn off, laden"
    ./build/release/examples/drain/drain_gallery "$out/drain"
    echo "== a needle, passed through both marks of a drain by two scripted hands"
    ./build/release/examples/needle/pass_needle -v -s 1 -p "$out/needle" -l "$out/needle/pass.vbss"
    echo "== the whole task by a scripted surgeon: through both marks, three throws, both tails cut (two or three minutes)"
    if ./build/release/examples/surgeon/surgeon -s 0 -l "$out/surgeon/stitch.vbss" -a "$out/surgeon/stages"; then
        touch "$out/surgeon/complete"
    fi
    echo "== stills of it and a film at six times its speed, through a laparoscope; a page that plays it in any browser"
    ./build/release/examples/viewer/viewer --replay "$out/surgeon/stitch.vbss" --png "$out/surgeon" --every 4 --size 640x480 ||
        [ $? -eq 77 ] # no OpenGL here: no stills
    ./build/release/examples/viewer/viewer --replay "$out/surgeon/stitch.vbss" --mp4 "$out/surgeon/task.mp4" --every 0.2 --size 480x360 ||
        [ $? -eq 77 ]
    ./build/release/examples/replay_page/vbss-replay-page "$out/surgeon/stitch.vbss" -o "$out/surgeon/stitch.html"
    echo "== what a teacher gets of the task, a knot and a passed needle, from their logs"
    ./build/release/examples/report/vbss-report "$out/surgeon/stitch.vbss" -o "$out/report/task.html" --pictures "$out/surgeon/stages"
    cp "$out"/throws/surgeons-*.png "$out/report"
    ./build/release/examples/report/vbss-report "$out/throws/surgeons.vbss" -o "$out/report/surgeons.html" --pictures "$out/report"
    ./build/release/examples/report/vbss-report "$out/needle/pass.vbss" -o "$out/report/pass.html" --pictures "$out/needle"
    echo "== the golden scenes, built here: the same bits as everywhere"
    python3 -B tests/determinism/matrix.py --work "$out/golden" --only gcc-O3
} | tee "$out/report.txt"

echo
echo "The library is in build/release/lib, this report in $out/report.txt,"
echo "the whole task in $out/surgeon: stages/*.png (its key stages), frame-*.png and task.mp4 (through a laparoscope), stitch.html (plays in a"
echo "browser), stitch.vbss (the log; ./examples/play.sh: with a mouse),"
echo "the hands at work in $out/throws: <knot>.png (all key stages), <knot>-<throw>-<stage>.png, <knot>.vbss (the log),"
echo "the drain, touched, in $out/drain, the needle on its way through it in $out/needle,"
echo "pages of the sessions in $out/report: task.html, surgeons.html, pass.html; open them in a browser,"
echo "pictures of the knots in $out/knots: <knot>.png (tight), <knot>-stages.png, <knot>-throws.png (as told), <knot>.svg."
if [ -e "$out/surgeon/complete" ]; then
    echo "The task was completed."
else
    echo "The task was not completed: $out/report.txt says why."
    exit 1
fi
