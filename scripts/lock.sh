#!/bin/bash
# lock.sh [UV OPTION...]: writes requirements.txt from requirements.in, and so those of the adapters and of packaging/: each
# package at one version for all systems, with the digest of every file that its version was published as. Versions stand
# unless --upgrade, or --upgrade-package NAME, is given. uv asks the package index that it is set up for; its address is not
# written.
set -euo pipefail
cd "$(dirname "$0")/.."
for source in requirements.in fuzz/adapters/*.requirements.in packaging/*.requirements.in; do
  lock=${source%.in}.txt
  UV_CUSTOM_COMPILE_COMMAND="make lock" .venv/bin/uv pip compile "$source" --output-file "$lock" --quiet \
    --python-version 3.11 --universal --fork-strategy fewest --generate-hashes --no-emit-index-url "$@"
  echo "minkref: $lock: $(grep -c == "$lock") packages, $(grep -c -- --hash= "$lock") digests"
done
