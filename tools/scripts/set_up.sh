#!/bin/bash
# set_up.sh [packages|environment|run|build]: everything that a fresh clone needs, up to the named step (all without a
# name). `run` builds what the main job takes, and again what was built before; `build` the tests and all programs too.
# Each step is skipped when what it depends on has not changed: its key, a hash of contents, stands in a stamp.
set -euo pipefail
cd "$(dirname "$0")/../.."
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
done <tools/scripts/debian_packages.txt
if ! tools/scripts/find_python.sh >/dev/null; then
  [[ -z ${PYTHON:-} ]] || { say "PYTHON=$PYTHON is not a Python >= 3.11 with venv and headers" >&2; exit 2; }
  packages+=(python3 python3-venv python3-dev)
fi
tools/scripts/require_packages.sh "${packages[@]}"
[[ $last == packages ]] && exit 0

# 2. The virtual environment .venv, with pinned packages.
python=$(tools/scripts/find_python.sh) || { say "no Python >= 3.11 with venv and headers" >&2; exit 2; }
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

# 4. Build, and put the package into .venv. A terminal gets one line that changes; the log has all.
targets=()
if [[ $last == run ]]; then
  targets=(minkref_run)
  for program in build/release/oracle/*/minkref-*; do
    if [[ -f $program && -x $program ]]; then targets+=("${program##*/}"); fi
  done
fi
shown() {
  if [[ -t 1 ]]; then
    awk '/^\[[0-9]+\/[0-9]+\]/ { printf "\r\033[Kminkref: build %s", substr($1, 2, length($1) - 2); fflush(); some = 1 }
         END { if (some) printf "\r\033[K" }'
  else
    cat
  fi
}
if ! cmake --build build/release -j "$(nproc)" ${targets[@]:+--target "${targets[@]}"} 2>&1 | tee build/build.log | shown; then
  if [[ -t 1 ]]; then tail -n 30 build/build.log >&2; fi
  say "the build failed: build/build.log has all of it" >&2
  exit 2
fi
.venv/bin/python tools/scripts/link_package.py
