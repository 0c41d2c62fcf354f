"""Folders of minkref outside the package: for user data, and for installed adapters."""

from __future__ import annotations

import os
from pathlib import Path

HERE = Path(__file__).parent


def state_folder() -> Path:
    """The folder of a user's data that minkref keeps from run to run and no target may see."""
    given = Path(os.environ.get("XDG_STATE_HOME", ""))
    base = given if given.is_absolute() else Path(os.path.expanduser("~"), ".local", "state")
    return base / "minkref"


def adapters_folder() -> Path:
    """MINKREF_ADAPTERS, else build/adapters of the checkout, else below ~/.cache."""
    given = os.environ.get("MINKREF_ADAPTERS")
    if given:
        return Path(given)
    checkout = HERE.resolve().parents[1]
    if (checkout / "pyproject.toml").is_file():
        return checkout / "build" / "adapters"
    return Path.home() / ".cache" / "minkref" / "adapters"
