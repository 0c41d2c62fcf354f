"""The version number: that with which the extension module was built, or of the checkout that is
run in place."""

from __future__ import annotations

from pathlib import Path


def version() -> str:
    """The version in pyproject.toml, as the extension module has it or, where that is not built,
    read from the checkout."""
    try:
        from minkref import _core
    except ImportError:
        import tomllib

        project = Path(__file__).resolve().parents[1] / "pyproject.toml"
        if not project.is_file():
            return "unknown"
        return str(tomllib.loads(project.read_text(encoding="utf-8"))["project"]["version"])
    return str(_core.__version__)
