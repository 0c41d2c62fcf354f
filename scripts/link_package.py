"""Makes the checkout the package `minkref` of .venv: an edited Python file is seen at once.

The package is spread over the rooms of the repository (the table in pyproject.toml).
build/package/minkref holds a link to each piece and to the extension module of build/release; a
path file in .venv names build/package. Command, metadata and CGAL executables go beside the
interpreter.

link_package.py BUILD: only the links, in BUILD/package, with the extension module of BUILD. With
PYTHONPATH=BUILD/package it comes before that of build/release.
"""

from __future__ import annotations

import shutil
import sys
import sysconfig
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "build" / "package"
BUILD = ROOT / "build" / "release"
PROVED = "minkref-check-proved"  # of `make proofs`


def set_links(folder: Path, wanted: dict[Path, Path]) -> None:
    """Leaves exactly the links `wanted` (path below `folder` to target), touching no right one."""
    for path in sorted(folder.rglob("*"), reverse=True):
        if path.is_symlink():
            if wanted.get(path.relative_to(folder)) != path.readlink():
                path.unlink()
        elif path.is_dir() and not any(path.iterdir()):
            path.rmdir()
    for name, target in wanted.items():
        where = folder / name
        if not where.is_symlink():
            where.parent.mkdir(parents=True, exist_ok=True)
            where.symlink_to(target)


def rooms_of_package(rooms: dict[str, str], build: Path = BUILD) -> dict[Path, Path]:
    """A link for each entry of the package's own folder, each room, and the extension module."""
    wanted: dict[Path, Path] = {}
    for name, folder in rooms.items():
        if "/" in name:
            wanted[Path(name)] = ROOT / folder
            continue
        for entry in (ROOT / folder).iterdir():
            if entry.name != "__pycache__":
                wanted[Path(name, entry.name)] = entry
        for built in (build / "python").glob("_core*"):
            if built.suffix in (".so", ".pyi"):
                wanted[Path(name, built.name)] = built
    return wanted


def write_metadata(site: Path, project: dict[str, object]) -> None:
    """What importlib.metadata reads of an installed distribution."""
    for old in site.glob("minkref-*.dist-info"):
        shutil.rmtree(old)
    info = site / f"minkref-{project['version']}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: minkref\nVersion: {project['version']}\n"
        f"Summary: {project['description']}\n",
        encoding="utf-8",
    )
    (info / "INSTALLER").write_text("scripts/link_package.py\n", encoding="utf-8")
    (info / "RECORD").write_text("", encoding="utf-8")
    (site / "minkref.pth").write_text(f"{PACKAGE}\n", encoding="utf-8")


def write_command(command: Path, entry: str) -> None:
    module, function = entry.split(":")
    command.write_text(
        f"#!{sys.executable}\nimport sys\n\nfrom {module} import {function}\n\n"
        # The guard lets worker processes import the command's module without running it.
        f'if __name__ == "__main__":\n    sys.exit({function}())\n',
        encoding="utf-8",
    )
    command.chmod(0o755)


def link_oracle(scripts: Path) -> None:
    """The executables of the oracle beside the interpreter, where the package looks for them."""
    for pattern in (
        "cgal/minkref-cgal-*",
        "checker/minkref-check",
        "sampled/minkref-sampled-events",
        "boost/minkref-boost-diagram",
    ):
        for old in scripts.glob(pattern.split("/")[1]):
            old.unlink()
        for built in (BUILD / "oracle").glob(pattern):
            if built.is_file():
                (scripts / built.name).symlink_to(built)
    proved = ROOT / "build" / "proofs" / PROVED
    (scripts / PROVED).unlink(missing_ok=True)
    if proved.is_file():
        (scripts / PROVED).symlink_to(proved)


def main() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    rooms = project["tool"]["scikit-build"]["wheel"]["packages"]
    if len(sys.argv) > 1:
        build = Path(sys.argv[1]).resolve()
        (build / "package").mkdir(parents=True, exist_ok=True)
        set_links(build / "package", rooms_of_package(rooms, build))
        return
    PACKAGE.mkdir(parents=True, exist_ok=True)
    set_links(PACKAGE, rooms_of_package(rooms))
    write_metadata(Path(sysconfig.get_path("purelib")), project["project"])
    scripts = Path(sysconfig.get_path("scripts"))
    for name, entry in project["project"]["scripts"].items():
        write_command(scripts / name, entry)
    link_oracle(scripts)


if __name__ == "__main__":
    main()
