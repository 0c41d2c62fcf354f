#!/bin/bash
# require_packages.sh PACKAGE...: sees to it that these Debian packages are installed.
# As root it installs those that are missing and names each; otherwise it prints the one command
# that installs them and stops with 2. On a system without dpkg it names them and goes on: the
# configuration by CMake then tells what is not there.
set -euo pipefail

if ! command -v dpkg-query >/dev/null; then
  echo "minkref: not a Debian system; needed are its counterparts of: $*" >&2
  exit 0
fi

missing=()
for package in "$@"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
[[ ${#missing[@]} -gt 0 ]] || exit 0

if [[ $(id -u) -ne 0 ]]; then
  echo "minkref: Debian packages are missing. As root, run:" >&2
  echo "apt-get install ${missing[*]}" >&2
  exit 2
fi

for package in "${missing[@]}"; do
  echo "minkref: installing the Debian package $package"
done
log=$(mktemp)
trap 'rm -f "$log"' EXIT
install() {
  DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}
# The package lists may be absent (a fresh container) or too old (a version that is gone).
if ! install >"$log" 2>&1 && ! { apt-get update && install; } >"$log" 2>&1; then
  tail -n 20 "$log" >&2
  echo "minkref: apt-get could not install: ${missing[*]}" >&2
  exit 2
fi
