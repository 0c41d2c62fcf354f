#!/bin/bash
# docs.sh: builds the documentation as a site in build/site (`make docs`): the pages of the repository, with search and dark
# mode, and the reference, which is made from docstrings, headers, the command line and the schemas. Fetches packages the
# first time, and when docs/site/requirements.txt has changed; after that it needs no network.
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p build/stamps build/docs
exec 8>build/stamps/docs.lock
flock 8

command -v doxygen >/dev/null || tools/scripts/require_packages.sh doxygen
environment=build/docs/environment
key=$({ printf '%s\n' "$PWD" "$(.venv/bin/python -VV)"; cat docs/site/requirements.txt; } | sha256sum | cut -d' ' -f1)
if [[ ! -f build/stamps/docs || $(<build/stamps/docs) != "$key" || ! -x $environment/bin/python ]]; then
  echo "minkref: making $environment"
  rm -f build/stamps/docs
  .venv/bin/python -m venv --clear "$environment"
  "$environment/bin/python" -m pip install --quiet --disable-pip-version-check --require-hashes --only-binary :all: \
    -r docs/site/requirements.txt || { echo "minkref: pip could not install the packages of docs/site/requirements.txt" >&2; exit 2; }
  echo "$key" >build/stamps/docs
fi

"$environment/bin/python" docs/site/stage.py build/docs
NO_MKDOCS_2_WARNING=1 PATH="$PWD/$environment/bin:$PATH" \
  "$environment/bin/mkdocs" build --strict --quiet --config-file build/docs/mkdocs.yml
echo "minkref: build/site/index.html"
