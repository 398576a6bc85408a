#!/usr/bin/env bash
# Installs vrts once, when the image is built. Gradescope runs this as root.
# vrts is the file in `wheels`: its name is free on package indexes, so none is ever asked for it.
set -euo pipefail

root="${AUTOGRADER_ROOT:-/autograder}"
wheels="$root/source/wheels"
wheel="$(echo "$wheels/vrts-$(cat "$root/source/version")"-*.whl)"
if [ ! -f "$wheel" ]; then
  echo "the wheel of vrts is not in this zip: make the zip again with vrts grade init" >&2
  exit 1
fi

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
# what vrts needs comes from the zip if it is all there, else what is missing from the package index
"$root/vrts/bin/pip" install --no-index --find-links "$wheels" "$wheel" ||
  "$root/vrts/bin/pip" install --find-links "$wheels" "$wheel"
"$root/vrts/bin/vrts" --version
