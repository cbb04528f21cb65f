#!/usr/bin/env bash
# Suturing in a browser: installs what is missing, builds build/web/suturing.html, which opens from the disk.
#
#   examples/web.sh                  builds
#   examples/web.sh --serve [PORT]   and serves it to this machine alone, on port 8000 or that one
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

case "${1:-}" in
"" | --serve) ;;
*)
    sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac

.ci/install-packages web

out=build/web
mkdir -p "$out"
cmake --preset release >"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }
cmake --build --preset release --target web_page >>"$out/build.log" 2>&1 || { cat "$out/build.log"; exit 1; }
cp build/release/examples/web/suturing.html "$out/"
echo "Open $PWD/$out/suturing.html in a browser."
if [ "${1:-}" = --serve ]; then
    port=${2:-8000}
    echo "Or http://localhost:$port/suturing.html, until Ctrl-C."
    exec python3 -m http.server --bind 127.0.0.1 --directory "$out" "$port"
fi
