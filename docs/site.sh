#!/usr/bin/env bash
# The documentation as a site with search: installs what is missing, builds, says where it is. Every warning is an error.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

.ci/install-packages docs
python3 -B docs/site.py . build/site
