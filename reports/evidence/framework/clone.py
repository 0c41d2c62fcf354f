"""Fresh clones of this checkout, and commands in them that get nothing else from it."""

from __future__ import annotations

import os
import resource
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

from minkref.reports.evidence.framework.places import FOLDER, ROOT


@dataclass(frozen=True)
class Taken:
    """Seconds on the clock, and of all processors."""

    clock: float
    processor: float
    code: int

    def __str__(self) -> str:
        return f"{self.clock:.0f} s ({self.processor:.0f} s of processor time)"


class Clone:
    """A commit's files under the folder `root`."""

    def __init__(self, root: Path, commit: str = "HEAD") -> None:
        self.root = root
        subprocess.run(["git", "clone", "--quiet", ROOT, root], check=True)
        git(root, "checkout", "--quiet", commit)

    def call(self, title: str, *command: str) -> Taken:
        """Runs a command with PATH and HOME alone in the environment and the compiler cache
        switched off, so that times are a cold cache's. The log goes to build/evidence."""
        log = FOLDER / "clones" / f"{self.root.name} {title}.log".replace(" ", "-")
        log.parent.mkdir(parents=True, exist_ok=True)
        path = [part for part in os.environ["PATH"].split(":") if str(ROOT / ".venv") not in part]
        environment = {"PATH": ":".join(path), "HOME": os.environ["HOME"], "CCACHE_DISABLE": "1"}
        began, spent = time.monotonic(), processor_seconds()
        with open(log, "w", encoding="utf-8") as out:
            done = subprocess.run(
                command, cwd=self.root, env=environment, stdin=subprocess.DEVNULL,
                stdout=out, stderr=out, check=False,
            )  # fmt: skip
        clock = time.monotonic() - began
        taken = Taken(clock, processor_seconds() - spent, done.returncode)
        print(f"{self.root.name}: {title}: exit code {done.returncode}, {taken}", flush=True)
        return taken


def git(folder: Path, *words: str) -> str:
    """The output of a git command."""
    command = ["git", "-C", str(folder), *words]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return done.stdout.strip()


def processor_seconds() -> float:
    """Processor seconds of all ended children."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime
