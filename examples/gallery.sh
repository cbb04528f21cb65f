#!/usr/bin/env bash
# Everything beside the main task of examples/demo.sh: embedding, throws, knots, the drain, a needle, golden scenes. Installs what
# is missing, builds, runs, says where the results are.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

.ci/install-packages gallery

out=build/gallery
mkdir -p "$out/knots" "$out/throws" "$out/drain" "$out/vessel" "$out/pad" "$out/needle" "$out/report"
echo "== building (release)"
cmake --preset release >"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }
cmake --build --preset release --target embed_c embed_cpp first_throw knot_gallery drain_gallery vessel pad pass_needle vbss_report >>"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }

programs=build/release/examples
{
    echo "== embedding in C"
    "$programs/embed_c"
    echo "== embedding in C++"
    "$programs/embed_cpp"
    echo "== from a device's sample to a certified throw: two scripted hands tie"
    "$programs/throw/first_throw" -o "$out/throws" -s 2 single double surgeons
    echo "== tying knots, and what the detector says of them"
    "$programs/knots/knot_gallery" "$out/knots"
    echo "== the drain: poked, pinched, shut, opened, pushed in, torn off, loaded"
    "$programs/drain/drain_gallery" "$out/drain"
    echo "== a vessel is tied off"
    "$programs/vessel/vessel" "$out/vessel"
    echo "== a pad of skin is sutured by two scripted hands"
    "$programs/pad/pad" "$out/pad"
    echo "== a needle, passed through both marks of a drain by two scripted hands"
    "$programs/needle/pass_needle" -v -s 1 -p "$out/needle" -l "$out/needle/pass.vbss"
    echo "== reports of a knot, of a passed needle and of a running suture, from their logs"
    cp "$out"/throws/surgeons-*.png "$out/report"
    "$programs/report/vbss-report" "$out/throws/surgeons.vbss" -o "$out/report/surgeons.html" --pictures "$out/report"
    "$programs/report/vbss-report" "$out/needle/pass.vbss" -o "$out/report/pass.html" --pictures "$out/needle"
    "$programs/report/vbss-report" "$out/pad/pad.vbss" -o "$out/report/pad.html" --pictures "$out/pad"
    echo "== the golden scenes, built here: the same bits as everywhere"
    python3 -B tests/determinism/matrix.py --work "$out/golden" --only gcc-O3
} | tee "$out/report.txt"

cat <<END

This text is in $out/report.txt. Further results:
$out/throws: <knot>.png (all key stages), <knot>-<throw>-<stage>.png, <knot>.vbss (the log)
$out/knots: <knot>.png (tight), <knot>-stages.png, <knot>-throws.png (as detected), <knot>.svg
$out/drain, $out/needle: pictures of the drain under load, and of the needle on its way through it
$out/pad: pictures of each bite in a pad of skin, pad.vbss (the log)
$out/report: surgeons.html, pass.html and pad.html, for a browser
END
