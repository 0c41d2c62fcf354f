"""Runs `python3 -m slow`, or `python3 -m minkref.oracle.slow` if the package links to the
folder."""

import sys
import traceback

from .command import main

INTERNAL = 70  # 1 would say that `compare` found another set

if __name__ == "__main__":
    try:
        code = main()
    except Exception:  # noqa: BLE001 the border of the program
        traceback.print_exc()
        code = INTERNAL
    sys.exit(code)
