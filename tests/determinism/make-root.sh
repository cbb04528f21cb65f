#!/bin/sh
# Makes a folder with Python and numpy of another machine, out of Debian's packages, for performances.py --root. Changes
# nothing outside the folder.
#
#     make-root.sh FOLDER [ARCHITECTURE]     default: arm64
set -eu
folder=${1:?usage: make-root.sh FOLDER [ARCHITECTURE]}
architecture=${2:-arm64}
mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial" "$folder/root"
folder=$(cd "$folder" && pwd)
: > "$folder/apt/status"

apt() {
  apt-get -q -o Dir::State::Lists="$folder/apt/lists" -o Dir::State::status="$folder/apt/status" \
    -o Dir::Cache="$folder/apt/cache" -o APT::Architecture="$architecture" -o APT::Architectures="$architecture" \
    -o APT::Sandbox::User=root "$@"
}

apt update
apt --yes --download-only --no-install-recommends install python3-minimal python3-numpy
for package in "$folder"/apt/cache/archives/*.deb; do
  dpkg --extract "$package" "$folder/root"
done
