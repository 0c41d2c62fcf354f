"""Files in forbidden places. Each is a marker `minkref-hostile...`, and no existing file changes.
The adapter's version tells which files it could write."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

from bounds import GIGABYTE
from honest import Adapter, Request
from reach import got

NAME = "minkref-hostile-marker"


class WritesEverywhere(Adapter):
    """Writes a marker into each important folder."""

    def mischief(self, request: Request) -> str:
        def mark(folder: str) -> bool:
            path = Path(folder, f"{NAME}-{self.run}")
            path.write_text("a hostile adapter was here\n")
            return True

        places = {name: self.told[name] for name in ("work", "home", "checkout")}
        places |= {"etc": "/etc", "bin": "/usr/local/bin", "var": "/var/tmp", "root": "/"}
        places |= {"tmp": "/tmp", "shm": "/dev/shm", "run": "/run"}
        return got((name, lambda folder=folder: mark(folder)) for name, folder in places.items())


class FillsTheTemporaryFolder(Adapter):
    """Writes a gigabyte into the temporary folder, half of it to a file without a name."""

    def mischief(self, request: Request) -> str:
        block = b"\1" * (1 << 20)
        self.unnamed = tempfile.TemporaryFile()
        named = Path(tempfile.gettempdir(), NAME + "-large")
        written = 0
        with open(named, "wb") as stream:
            for target in (stream, self.unnamed):
                try:
                    for _ in range(GIGABYTE // len(block) // 2):
                        written += target.write(block)
                    target.flush()
                except OSError:
                    break
        return f"wrote {written >> 20} MiB"


class LeavesFiles(Adapter):
    """Leaves files and folders, hard to remove, below the temporary folder."""

    def mischief(self, request: Request) -> None:
        folder = Path(tempfile.mkdtemp(prefix="minkref-hostile-"))
        closed = folder / "closed"
        closed.mkdir()
        (closed / "file").touch()
        closed.chmod(0)
        os.mkfifo(folder / "pipe")
        (folder / "out").symlink_to(self.told["home"])
        (folder / "round").symlink_to("round")
        open(os.fsencode(folder) + b"/\xff\n\x1b", "w").close()
        for k in range(1000):
            (folder / f"file-{k}").touch()
        here = os.getcwd()
        os.chdir(folder)
        for _ in range(300):
            os.mkdir("deep" * 30)
            os.chdir("deep" * 30)
        os.chdir(here)


class LeavesFilesInTheWorkFolder(Adapter):
    """Leaves files, links and pipes in its working folder."""

    def mischief(self, request: Request) -> None:
        try:
            Path(NAME).write_text("here")
            Path(NAME + "-link").symlink_to("/etc/passwd")
            os.mkfifo(NAME + "-pipe")
        except OSError:
            return


class SwapsTheTemporaryFolder(Adapter):
    """Replaces each temporary folder that it finds with a link to a folder of the user, so that a
    clean-up would remove the user's files."""

    def mischief(self, request: Request) -> None:
        for folder in {Path(tempfile.gettempdir()), Path(os.environ.get("TMPDIR", "/nowhere"))}:
            for path in folder.glob("*minkref*") if str(folder) != "/tmp" else ():
                try:
                    path.rename(path.with_name("minkref-hostile-moved"))
                    path.symlink_to(self.told["home"])
                except OSError:
                    continue


class LeavesThroughLinks(Adapter):
    """Puts links in the run's folder, under the names of the run's output files."""

    def mischief(self, request: Request) -> None:
        target = Path(self.told["home"], "canary")
        for name in ("run.ledger", "junit.xml", "out.sarif", "summary.md", "lines.jsonl"):
            path = Path(self.told["work"], name)
            for there in (path, path.with_name(name + ".part"), path.with_name(name + ".tmp")):
                try:
                    there.unlink(missing_ok=True)
                    there.symlink_to(target)
                except OSError:
                    continue
