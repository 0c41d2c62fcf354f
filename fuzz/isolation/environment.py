"""The variables that a foreign program receives: a short list."""

from __future__ import annotations

import os
from collections.abc import Iterable

# Variables for language, places of programs and libraries, and our own (docs/security.md).
NAMES = (
    *("PATH", "LANG", "LANGUAGE", "TZ", "LD_LIBRARY_PATH", "NODE_PATH", "JAVA_HOME", "CLASSPATH"),
    *("VIRTUAL_ENV", "CONDA_PREFIX", "PYENV_ROOT", "PYENV_VERSION", "RUSTUP_HOME", "CARGO_HOME"),
    *("JULIA_DEPOT_PATH", "OMP_NUM_THREADS", "OPENSCAD"),
)
# HOME is not handed on; these variables point to existing folders below it instead.
BELOW_HOME = {
    "PYTHONUSERBASE": ".local",
    "RUSTUP_HOME": ".rustup",
    "CARGO_HOME": ".cargo",
    "JULIA_DEPOT_PATH": ".julia",
}
PREFIXES = ("LC_", "PYTHON", "MINKREF_")
MARK = "MINKREF_STARTED_BY"  # finds processes that a program left behind


def listed_variables(passed: Iterable[str]) -> dict[str, str]:
    """Returns our variables from the list, or `passed` by name."""
    wanted = {*NAMES, *passed}
    return {
        name: value
        for name, value in os.environ.items()
        if name in wanted or name.startswith(PREFIXES)
    }


def environment_of(
    passed: tuple[str, ...], more: dict[str, str], folder: str, home: str, mark: str
) -> dict[str, str]:
    """Returns a program's initial variables. `folder` holds the program's temporary files, `home`
    becomes HOME, unless HOME is passed."""
    own = {"HOME": home, "TMPDIR": folder}
    for name, place in BELOW_HOME.items():
        path = os.path.join(os.path.expanduser("~"), place)
        if os.path.isdir(path):
            own[name] = path
    return {**own, **listed_variables(passed), **more, MARK: mark}
