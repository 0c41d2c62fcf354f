"""One run of `minkref verify` on a hostile target, and all visible traces of the run."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
import tempfile
import threading
import uuid
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import outside

FOLDER = Path(__file__).resolve().parent
ADAPTERS = FOLDER / "adapters"
HEADERS = FOLDER.parents[2] / "fuzz" / "adapters"
OURS = "minkref:winding"  # right, and asked beside: its verdicts must not change
PATIENCE = 420.0  # seconds that a run may take; two answers may take the judge two minutes each
OUTPUTS = ("--ledger", "run.ledger", "--report", "report", "--junit", "junit.xml")
OUTPUTS += ("--sarif", "out.sarif", "--markdown", "summary.md", "--lines", "lines.jsonl")
WRITTEN = {"run.ledger", "junit.xml", "out.sarif", "summary.md", "lines.jsonl"}


@dataclass
class Seen:
    """A run's doings, as the run and the kernel tell them."""

    code: int | None
    seconds: float
    document: dict[str, Any] | None
    stderr: str
    processes: list[str]
    outside: list[str]  # files, sockets, shared memory
    home: list[str]  # what changed in the folder of the user
    temporary: list[str]  # what is left in the folder for temporary files
    work: list[str]  # what is in the run's folder that it was not told to write
    connections: int  # to the server on the loopback address
    files: dict[str, str] = field(default_factory=dict)  # that the run wrote
    terminal: dict[str, Any] = field(default_factory=dict)

    def verdicts(self, ours: bool = False) -> dict[str, int]:
        counts: dict[str, int] = {}
        for row in (self.document or {}).get("matrix", []):
            if (row["target"] == OURS) == ours:
                for verdict, count in row["verdicts"].items():
                    counts[verdict] = counts.get(verdict, 0) + count
        return counts

    @property
    def version(self) -> str:
        """The version of the hostile target; it names the things that the target got at."""
        others = [t for t in (self.document or {}).get("targets", []) if t["name"] != OURS]
        return str(others[0].get("version", "")) if others else ""


class Server:
    """On the loopback address, by TCP, by UDP and under an abstract name; counts who comes."""

    def __init__(self, run: str) -> None:
        self.count = 0
        self.tcp = socket.create_server(("127.0.0.1", 0))
        self.port = self.tcp.getsockname()[1]
        self.udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.udp.bind(("127.0.0.1", self.port))
        self.unix = socket.socket(socket.AF_UNIX)
        self.unix.bind(f"\0{outside.MARK}-{run}")
        self.unix.listen()
        for stream in (self.tcp, self.unix):
            threading.Thread(target=self.accept, args=(stream,), daemon=True).start()
        threading.Thread(target=self.receive, daemon=True).start()

    def accept(self, stream: socket.socket) -> None:
        while True:
            try:
                stream.accept()[0].close()
            except OSError:
                return
            self.count += 1

    def receive(self) -> None:
        while True:
            try:
                _, sender = self.udp.recvfrom(64)
                self.udp.sendto(b"here", sender)
            except OSError:
                return
            self.count += 1

    def close(self) -> None:
        for stream in (self.tcp, self.udp, self.unix):
            stream.close()


def compiled(folder: Path) -> Path:
    """The hostile C functions as a library."""
    library = folder / "functions.so"
    words = ["cc", "-shared", "-fPIC", "-w", f"-I{HEADERS}", str(ADAPTERS / "functions.c")]
    subprocess.run([*words, "-o", str(library)], check=True)
    return library


def free_port() -> int:
    with socket.socket() as stream:
        stream.bind(("127.0.0.1", 0))
        return int(stream.getsockname()[1])


def attack(
    target: str, *words: str, told: str = "", beside: bool = True, tty: bool = False
) -> Seen:
    """`target`: the name of a hostile adapter, or a function with colons. `told`: further words for
    the adapter. `words`: options of verify."""
    run = uuid.uuid4().hex[:12]
    server, free = Server(run), free_port()
    base = Path(tempfile.mkdtemp(prefix="minkref-evidence-"))
    try:
        places = {name: base / name for name in ("work", "home", "tmp")}
        for place in places.values():
            place.mkdir()
        (places["home"] / "canary").write_text("untouched\n")
        secret = f"secret-{run}"
        tells = {"run": run, "work": places["work"], "home": places["home"], "secret": secret[::-1]}
        tells |= {"checkout": outside.CHECKOUT, "port": server.port, "free": free}
        if ":" not in target:
            adapter = f"{sys.executable} {ADAPTERS / 'adapter.py'} {target}"
            target = f"cmd:{adapter} {' '.join(f'{k}={v}' for k, v in tells.items())} {told}"
        if target.startswith("so:"):
            target = f"so:{compiled(base)}:{target.rpartition(':')[2]}"
        command = [sys.executable, "-m", "minkref", "verify", target.strip()]
        command += [OURS] * beside
        command += [*OUTPUTS, *words, "--json"]
        environment = {
            **os.environ,
            "HOME": str(places["home"]),
            "TMPDIR": str(places["tmp"]),
            "SECRET_OF_THE_USER": secret,
            "HOSTILE_RUN": run,
            "PYTHONPATH": str(ADAPTERS),
            "PYTHONDONTWRITEBYTECODE": "1",
            "MINKREF_HOSTILE": json.dumps({k: str(v) for k, v in tells.items()}),  # to functions
        }
        kept = base / "kept"
        parent = [sys.executable, str(FOLDER / "supervisor.py"), str(kept), str(PATIENCE)]
        parent += ["tty"] * tty
        home = outside.listing(places["home"])
        subprocess.run([*parent, "--", *command], cwd=places["work"], env=environment, check=True)
        seen_by_parent = json.loads(kept.read_text())
        seen = Seen(
            code=seen_by_parent["code"],
            seconds=seen_by_parent["seconds"],
            document=document(Path(f"{kept}.stdout")),
            stderr=Path(f"{kept}.stderr").read_text(errors="replace")[-20000:],
            processes=seen_by_parent["left"],
            outside=outside.left(run, free),
            home=changed(home, outside.listing(places["home"])),
            temporary=sorted(os.listdir(places["tmp"])),
            work=unknown(places["work"]),
            connections=server.count,
            files=written(places["work"]),
            terminal=seen_by_parent,
        )
        outside.remove(run)
        return seen
    finally:
        server.close()
        outside.remove_folder(base)


def document(path: Path) -> dict[str, Any] | None:
    try:
        value = json.loads(path.read_bytes())
    except ValueError:
        return None
    return value if isinstance(value, dict) else None


def changed(before: dict[str, str], after: dict[str, str]) -> list[str]:
    return sorted(name for name, _ in before.items() ^ after.items())


def unknown(work: Path) -> list[str]:
    """Names of unexpected files and of links below the run's folder."""
    found = [path for path in work.iterdir() if path.name not in WRITTEN and path.name != "report"]
    return sorted(path.name for path in found + [p for p in work.rglob("*") if p.is_symlink()])


def written(work: Path) -> dict[str, str]:
    """The texts of the run's outputs."""
    paths = [path for path in work.rglob("*") if path.is_file() and not path.is_symlink()]
    return {
        str(path.relative_to(work)): path.read_bytes().decode(errors="replace")
        for path in paths
        if path.stat().st_size < 1 << 24
    }
