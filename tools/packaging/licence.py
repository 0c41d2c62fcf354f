"""Records the licences of bundled code in wheels: licence.py FOLDER, for the wheels there.

pyproject.toml states the licences of the sources. Compiled-in code and libraries from auditwheel
have further licences; this script adds them to a repaired wheel. LICENSES/THIRD_PARTY.md lists
where each component goes.
"""

from __future__ import annotations

import base64
import hashlib
import re
import sys
import zipfile
from pathlib import Path

IN_WHEELS = {
    "minkref": "Apache-2.0 AND BSD-3-Clause AND BSL-1.0 AND LGPL-3.0-or-later AND MIT AND MPL-2.0",
    "minkref_cgal": "BSL-1.0 AND GPL-3.0-or-later AND LGPL-3.0-or-later AND MIT",
}


def state(wheel: Path) -> None:
    """Writes the expression into METADATA, and the digest of METADATA into RECORD."""
    with zipfile.ZipFile(wheel) as old:
        contents = [(member, old.read(member)) for member in old.infolist()]
    by_name = {member.filename: content for member, content in contents}
    (name,) = (name for name in by_name if name.endswith(".dist-info/METADATA"))
    record = name.replace("METADATA", "RECORD")
    said = f"License-Expression: {IN_WHEELS[wheel.name.split('-')[0]]}"
    by_name[name] = _line(by_name[name], "License-Expression: ", said)
    by_name[record] = _line(by_name[record], f"{name},", _row(name, by_name[name]))
    with zipfile.ZipFile(wheel, "w") as new:
        for member, _ in contents:
            new.writestr(member, by_name[member.filename])


def _line(text: bytes, start: str, line: str) -> bytes:
    """The text with `line` in place of the only line that begins with `start`; exits unless exactly
    one line does."""
    pattern = rf"^{re.escape(start)}[^\r\n]*"
    changed, number = re.subn(pattern, line, text.decode(), flags=re.MULTILINE)
    if number != 1:
        raise SystemExit(f"minkref: {number} lines begin with {start}")
    return changed.encode()


def _row(name: str, content: bytes) -> str:
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}"


if __name__ == "__main__":
    for found in Path(sys.argv[1]).glob("*.whl"):
        state(found)
