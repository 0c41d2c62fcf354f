"""A bare machine: a root that holds only an interpreter, its libraries and an environment.

No compiler, headers, GMP, shell or network; the only other program is `env`, for scripts' first
lines. Bubblewrap mounts single files from this machine, read-only except a work folder.
"""

from __future__ import annotations

import json
import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

ASKED = """
import json, pathlib, sys, sysconfig
print(json.dumps({
    "program": str(pathlib.Path(sys._base_executable).resolve()),
    "library": sysconfig.get_path("stdlib", vars={"installed_base": sys.base_prefix}),
    "modules": sysconfig.get_config_var("DESTSHARED"),
}))
"""
# Libraries that a wheel for manylinux may take from the system: the C library's own, and C++'s.
OF_THE_SYSTEM = (
    "libc.so.6", "libm.so.6", "libdl.so.2", "librt.so.1", "libpthread.so.0", "libutil.so.1",
    "libgcc_s.so.1", "libstdc++.so.6",
)  # fmt: skip
#: Runs inside the root: lists files that a bare machine does not have.
SEARCH = r"""
import os, re, sys
programs = r"(cc|c\+\+|gcc|g\+\+|clang|cmake|sh|bash)$"
unwanted = re.compile(r"(gmp|mpfr)\.h$|lib(gmp|mpfr)[-.].*so|" + programs)
for folder, folders, files in os.walk("/"):
    if folder in ("/proc", "/sys", "/dev"):
        folders.clear()
    for name in files:
        if unwanted.match(name) and not folder.startswith(sys.prefix):
            print(os.path.join(folder, name))
"""


@dataclass
class BareRoot:
    """`environment` is a virtual environment; `work` is the folder that commands write to, and
    their home."""

    environment: Path
    work: Path
    mounts: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        command = [str(self.environment / "bin" / "python"), "-c", ASKED]
        asked = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
        library, modules = Path(asked["library"]), Path(asked["modules"])
        binaries = [Path(asked["program"]), Path("/usr/bin/env"), *modules.glob("*.so")]
        for file in sorted(shared_libraries(binaries)):
            self._bind(file)
        self._bind(Path("/usr/bin/env"))
        self._bind(Path(asked["program"]))
        self._bind(library)
        for folder in ("site-packages", "dist-packages", "ensurepip"):
            if (library / folder).is_dir():
                self.mounts += ["--tmpfs", str(library / folder)]
        # A virtual environment names the interpreter as it was called.
        link = self.environment / "bin" / "python"
        while link.is_symlink():
            link = link.parent / link.readlink()
            self._bind(link)
        self._bind(self.environment)
        self.mounts += ["--bind", str(self.work), str(self.work)]

    def _bind(self, path: Path) -> None:
        self.mounts += ["--ro-bind", str(path), str(path)]

    def command(self, *words: str) -> list[str]:
        """The command line that runs `words` inside, in the work folder."""
        variables = {
            "PATH": str(self.environment / "bin"),
            "HOME": str(self.work),
            "LANG": "C.UTF-8",
            "COLUMNS": "100",
        }
        given = [word for name, value in variables.items() for word in ("--setenv", name, value)]
        walls = ["--unshare-all", "--die-with-parent", "--new-session", "--clearenv", *given]
        system = ["--proc", "/proc", "--dev", "/dev", "--tmpfs", "/tmp"]
        return ["bwrap", *walls, *system, *self.mounts, "--chdir", str(self.work), *words]

    def unwanted(self) -> list[str]:
        """Files that no bare machine has: compilers, shells, GMP headers and libraries."""
        command = self.command(str(self.environment / "bin" / "python"), "-c", SEARCH)
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()


def shared_libraries(binaries: list[Path]) -> set[Path]:
    """Shared libraries that the binaries load, plus the libraries that a manylinux wheel expects on
    every system."""
    found: set[Path] = set()
    for binary in binaries:
        said = subprocess.run(["ldd", binary], capture_output=True, text=True).stdout
        found |= {Path(path) for path in re.findall(r"(/\S+) \(0x", said)}
    cache = subprocess.run(
        ["ldconfig", "-p"], capture_output=True, text=True, env={"PATH": "/usr/sbin:/sbin:/usr/bin"}
    ).stdout
    for name in OF_THE_SYSTEM:
        paths = re.findall(rf"^\s*{re.escape(name)} \(libc6,\S*64\S*\) => (\S+)$", cache, re.M)
        found |= {Path(path) for path in paths[:1]}
    return {path for path in found if not re.match(r"lib(gmp|mpfr)", path.name)}
