"""The commands of docs/first-finding.md do what the page says, in an empty folder."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs" / "first-finding.md"
TIMES = re.compile(r"\d+\.\d+")  # seconds, which differ


def transcript() -> list[tuple[str, list[str]]]:
    """Each command of the page with the lines below it."""
    found: list[tuple[str, list[str]]] = []
    for block in re.findall(r"```console\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL):
        for line in block.splitlines():
            if line.startswith("$ "):
                found.append((line.removeprefix("$ "), []))
            else:
                found[-1][1].append(line)
    return found


def plain(line: str) -> str:
    return " ".join(TIMES.sub("0.0", line).split())


def follows(shown: list[str], said: list[str]) -> bool:
    """The lines that are said are those shown, `...` being any number of lines."""
    if not shown:
        return not said
    if shown[0] == "...":
        return any(follows(shown[1:], said[k:]) for k in range(len(said) + 1))
    return bool(said) and plain(shown[0]) == plain(said[0]) and follows(shown[1:], said[1:])


def test_six_commands_lead_to_a_finding(tmp_path: Path) -> None:
    environment = {
        **os.environ,
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        "COLUMNS": "100",
    }
    commands = transcript()
    assert len(commands) == 6
    for command, shown in commands:
        ran = subprocess.run(
            command,
            shell=True,
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
            timeout=120,
        )
        finds = " wrong" in "\n".join(shown)
        assert (ran.returncode, ran.stderr) == (int(finds), ""), command
        assert follows(shown, ran.stdout.splitlines()), f"{command}\n{ran.stdout}"
