"""Makes the checkout the package `minkref` of .venv, so that edited Python files take effect at
once.

Rooms of the repository are parts of the package (see the table in pyproject.toml): the folder
minkref/ gets a link to each room, and to the extension module of build/release; git ignores the
links. A path file in .venv names the checkout. Command, metadata and CGAL executables go beside the
interpreter.

link_package.py BUILD: makes a package of links in BUILD/package, with BUILD's extension module.
With PYTHONPATH=BUILD/package and PYTHONSAFEPATH=1 that package precedes the checkout's.
"""

from __future__ import annotations

import shutil
import sys
import sysconfig
import tomllib
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "minkref"
BUILD = ROOT / "build" / "release"
PROVED = "minkref-check-proved"  # of `make proofs`


def set_links(folder: Path, wanted: dict[Path, Path]) -> None:
    """Leaves exactly the links `wanted` (name in `folder` to target), without touching correct
    links."""
    for path in folder.iterdir():
        if path.is_symlink() and wanted.get(Path(path.name)) != path.readlink():
            path.unlink()
    for name, target in wanted.items():
        if not (folder / name).is_symlink():
            (folder / name).symlink_to(target)


def links_to(rooms: Iterable[str], build: Path) -> dict[Path, Path]:
    """Links to the rooms beside the package's own folder, and to the extension module."""
    beside = {Path(name).parts[1] for name in rooms if "/" in name}
    wanted = {Path(name): ROOT / name for name in beside}
    for built in (build / "bindings").glob("_core*"):
        if built.suffix in (".so", ".pyi"):
            wanted[Path(built.name)] = built
    return wanted


def set_package(folder: Path, rooms: Iterable[str], build: Path) -> None:
    """A package of links."""
    wanted = links_to(rooms, build)
    for entry in PACKAGE.iterdir():
        if entry.name != "__pycache__" and not entry.is_symlink():
            wanted[Path(entry.name)] = entry
    folder.mkdir(parents=True, exist_ok=True)
    set_links(folder, wanted)


def write_metadata(site: Path, project: dict[str, object]) -> None:
    """Writes the files of an installed distribution that importlib.metadata reads."""
    for old in site.glob("minkref-*.dist-info"):
        shutil.rmtree(old)
    info = site / f"minkref-{project['version']}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: minkref\nVersion: {project['version']}\n"
        f"Summary: {project['description']}\n",
        encoding="utf-8",
    )
    (info / "INSTALLER").write_text("tools/scripts/link_package.py\n", encoding="utf-8")
    (info / "RECORD").write_text("", encoding="utf-8")
    (site / "minkref.pth").write_text(f"{ROOT}\n", encoding="utf-8")


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
    """Links the oracle's executables beside the interpreter, where the package looks for them."""
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
        set_package(build / "package" / "minkref", rooms, build)
        return
    set_links(PACKAGE, links_to(rooms, BUILD))
    write_metadata(Path(sysconfig.get_path("purelib")), project["project"])
    scripts = Path(sysconfig.get_path("scripts"))
    for name, entry in project["project"]["scripts"].items():
        write_command(scripts / name, entry)
    link_oracle(scripts)


if __name__ == "__main__":
    main()
