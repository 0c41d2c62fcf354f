#!/bin/bash
# set_up.sh [packages|environment|build]: everything that a fresh clone needs, up to the named step (all without a name).
# Each step is skipped when what it depends on has not changed: its key, a hash of contents, stands in a stamp.
set -euo pipefail
cd "$(dirname "$0")/.."
last=${1:-build}
mkdir -p build/stamps
exec 9>build/stamps/lock
flock 9

say() { echo "minkref: $*"; }
key_of() { { printf '%s\n' "$PWD" "$@"; } | sha256sum | cut -d' ' -f1; }
content_of() { sha256sum "$@" | cut -d' ' -f1 | tr '\n' ' '; }
fresh() { [[ -f build/stamps/$1 && $(<"build/stamps/$1") == "$2" ]]; }

# 1. Debian packages.
packages=()
while read -r package command; do
  [[ -z $package || $package == \#* ]] && continue
  [[ $package == libcgal-dev && -n ${CGAL_DIR:-} ]] && continue
  [[ $command != - ]] && command -v "$command" >/dev/null && continue
  packages+=("$package")
done <scripts/debian_packages.txt
if ! scripts/find_python.sh >/dev/null; then
  [[ -z ${PYTHON:-} ]] || { say "PYTHON=$PYTHON is not a Python >= 3.11 with venv and headers" >&2; exit 2; }
  packages+=(python3 python3-venv python3-dev)
fi
scripts/require_packages.sh "${packages[@]}"
[[ $last == packages ]] && exit 0

# 2. The virtual environment .venv, with pinned packages.
python=$(scripts/find_python.sh) || { say "no Python >= 3.11 with venv and headers" >&2; exit 2; }
key=$(key_of "$python" "$("$python" -VV)" "$(content_of requirements.txt)")
if ! fresh environment "$key" || [[ ! -x .venv/bin/python ]]; then
  say "making .venv with $python"
  rm -f build/stamps/environment
  "$python" -m venv --clear .venv
  # Nothing without its digest, and nothing built here by tools that have none.
  .venv/bin/python -m pip install --quiet --disable-pip-version-check --require-hashes --only-binary :all: \
    -r requirements.txt || { say "pip could not install the packages of requirements.txt" >&2; exit 2; }
  echo "$key" >build/stamps/environment
fi
[[ $last == environment ]] && exit 0

# 3. Configure. CMake looks itself after its own files; this key is for what it does not see.
key=$(key_of "$python" "$(content_of CMakePresets.json requirements.txt)" \
  "${CGAL_DIR:-}" "${CXX:-}" "${CXXFLAGS:-}")
if ! fresh configure "$key" || [[ ! -f build/release/build.ninja ]]; then
  say "configuring build/release"
  rm -f build/stamps/configure
  cmake --preset release --fresh -DMINKREF_PYTHON=ON -DPython_EXECUTABLE="$PWD/.venv/bin/python" \
    ${CGAL_DIR:+-DCGAL_DIR="$CGAL_DIR"} >build/configure.log 2>&1 ||
    { tail -n 30 build/configure.log >&2; exit 2; }
  echo "$key" >build/stamps/configure
fi

# 4. Build, and put the package into .venv.
cmake --build build/release -j "$(nproc)"
.venv/bin/python scripts/link_package.py
