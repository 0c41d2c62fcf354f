#!/bin/bash
# lock.sh [UV OPTION...]: writes requirements.txt from requirements.in, and so those of the adapters, of tools/packaging/ and
# of the site: each package at one version for all systems, with the digest of every file that its version was published
# as. Versions stand unless --upgrade, or --upgrade-package NAME, is given. uv asks the package index that it is set up
# for; its address is not written.
set -euo pipefail
cd "$(dirname "$0")/../.."
# Packages that the site shares with the checkout have one version in both.
for source in requirements.in docs/site/requirements.in fuzz/libraries/*/requirements.in tools/packaging/*.requirements.in \
  tools/javascript/requirements.in; do
  lock=${source%.in}.txt
  shared=()
  [[ $source != docs/* ]] || shared=(--constraints requirements.txt)
  UV_CUSTOM_COMPILE_COMMAND="make lock" .venv/bin/uv pip compile "$source" --output-file "$lock" --quiet \
    --python-version 3.11 --universal --fork-strategy fewest --generate-hashes --no-emit-index-url "${shared[@]}" "$@"
  echo "minkref: $lock: $(grep -c == "$lock") packages, $(grep -c -- --hash= "$lock") digests"
done
