"""`minkref verify --help` loads no judge: the run does, once it is asked for."""

from __future__ import annotations

import subprocess
import sys

PROGRAM = """
import sys
import minkref.verbs.verify
heavy = ("minkref.fuzz.settings", "minkref.fuzz.run", "minkref.oracle", "minkref.certify")
print([name for name in sys.modules if name.startswith(heavy)])
"""


def test_the_command_stands_apart_from_the_run() -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"
