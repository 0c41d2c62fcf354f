"""The version number: from the built extension module, or from the checkout that runs in place."""

from __future__ import annotations

from pathlib import Path


def version() -> str:
    """Return the version in pyproject.toml, as built into the extension module, or read from the
    checkout if no module is built."""
    try:
        from minkref import _core
    except ImportError:
        import tomllib

        project = Path(__file__).resolve().parents[1] / "pyproject.toml"
        if not project.is_file():
            return "unknown"
        return str(tomllib.loads(project.read_text(encoding="utf-8"))["project"]["version"])
    return str(_core.__version__)
