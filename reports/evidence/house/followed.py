"""A checkout to which a recipe's patch has been applied."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

from minkref.reports.evidence.framework.places import ROOT

PATCHES = ROOT / "tests" / "recipes"


def files_of(recipe: str) -> list[str]:
    """Files that the recipe's patch changes or adds."""
    text = (PATCHES / f"{recipe}.patch").read_text(encoding="utf-8")
    return re.findall(r"^diff --git a/.+ b/(.+)$", text, re.MULTILINE)


def follow(recipes: list[str], folder: Path) -> None:
    """Fills `folder` with the tracked files, as hard links, and applies the patches. An unchanged
    file keeps its time. Raises CalledProcessError for a patch that does not apply."""
    shutil.rmtree(folder, ignore_errors=True)
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    for name in listed.stdout.splitlines():
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            os.link(ROOT / name, folder / name)
    outside = {**os.environ, "GIT_CEILING_DIRECTORIES": str(folder.parent)}
    for recipe in recipes:
        patch = PATCHES / f"{recipe}.patch"
        subprocess.run(["git", "apply", patch], cwd=folder, env=outside, check=True)


def environment(folder: Path, build: Path) -> dict[str, str]:
    """For Python with the checkout's package and the extension module of `build`."""
    package = folder / "build"
    package.mkdir(exist_ok=True)
    if not (package / "bindings").exists():
        (package / "bindings").symlink_to(build / "bindings")
    link = [str(folder / "tools/scripts/link_package.py"), str(package)]
    subprocess.run([ROOT / ".venv/bin/python", *link], check=True)
    return {**os.environ, "PYTHONPATH": str(package / "package"), "PYTHONSAFEPATH": "1"}
