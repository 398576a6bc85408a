#!/usr/bin/env bash
# Installs vrts once, when the image is built. Gradescope runs this as root.
set -euo pipefail

root="${AUTOGRADER_ROOT:-/autograder}"
wheels="$root/source/wheels"
wanted="vrts==$(cat "$root/source/version")"

python=""
for candidate in python3.13 python3.12 python3.11 python3; do
  if "$candidate" -c 'import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 11))' \
    2>/dev/null; then
    python="$candidate"
    break
  fi
done
if [ -z "$python" ]; then
  apt-get update
  apt-get install -y python3.11 python3.11-venv
  python=python3.11
fi

"$python" -m venv "$root/vrts"
if [ -d "$wheels" ]; then
  # all from the zip if it is all there, else what is missing from the package index
  "$root/vrts/bin/pip" install --no-index --find-links "$wheels" "$wanted" ||
    "$root/vrts/bin/pip" install --find-links "$wheels" "$wanted"
else
  "$root/vrts/bin/pip" install "$wanted"
fi
"$root/vrts/bin/vrts" --version
