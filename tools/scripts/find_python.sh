#!/bin/bash
# find_python.sh: prints the interpreter that the virtual environment is made from, and exits 1 where there is none.
# It is $PYTHON if that is set, else the first python3 on PATH, else a versioned or Debian's own; it must be
# 3.11 or newer and bring venv, pip (ensurepip) and the C headers.
set -euo pipefail

probe='
import os, sys, sysconfig
if sys.version_info < (3, 11):
    sys.exit(1)
import venv, ensurepip
header = os.path.join(sysconfig.get_path("include"), "Python.h")
if not os.path.isfile(header):
    sys.exit(1)
print(os.path.realpath(sys._base_executable))
'
candidates=(${PYTHON:+"$PYTHON"})
[[ -n ${PYTHON:-} ]] || candidates=(python3 python3.13 python3.12 python3.11 /usr/bin/python3)
for candidate in "${candidates[@]}"; do
  if found=$("$candidate" -I -c "$probe" 2>/dev/null); then
    echo "$found"
    exit 0
  fi
done
exit 1
