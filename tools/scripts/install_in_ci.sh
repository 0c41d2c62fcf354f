#!/bin/bash
# install_in_ci.sh: the first step of action.yml. Installs minkref into the Python of the job: the wheel of a release, where GitHub
# attests that it was built from the very commit that the action is used at; otherwise from the sources of the action.
# Reads ACTION_REPOSITORY (OWNER/minkref), ACTION_REF (a commit, or a tag) and GH_TOKEN.
set -uo pipefail
sources=$(cd "$(dirname "$0")/../.." && pwd)
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' "$sources/pyproject.toml")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

released_wheel() {
  local wheel proof=(--source-ref "refs/tags/$ACTION_REF")
  [[ $ACTION_REF =~ ^[0-9a-f]{40}$ ]] && proof=(--source-digest "$ACTION_REF")
  gh release download "v$version" --repo "$ACTION_REPOSITORY" --pattern 'minkref-*.whl' --dir "$work/all" || return
  # pip picks the wheel that fits; no other place is asked, so none can offer another one.
  python -m pip download --quiet --no-index --no-deps --find-links "$work/all" --dest "$work/one" \
    "minkref==$version" || return
  wheel=$(echo "$work"/one/minkref-*.whl)
  gh attestation verify "$wheel" --repo "$ACTION_REPOSITORY" "${proof[@]}" || return
  python -m pip install "$wheel"
}

if [[ -n ${ACTION_REPOSITORY:-} && -n ${ACTION_REF:-} ]] && released_wheel; then
  echo "minkref: installed the wheel of release v$version"
  exit 0
fi
echo "minkref: no wheel of a release fits ${ACTION_REF:-this checkout}; installing from the sources"
sudo apt-get update
# shellcheck disable=SC2046 # one word for each package
sudo apt-get install --yes --no-install-recommends \
  $(awk '!/^#/ && $1 != "libcgal-dev" && $1 != "ccache" { print $1 }' "$sources/tools/scripts/debian_packages.txt") &&
  python -m pip install "$sources"
