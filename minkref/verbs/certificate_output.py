"""A certificate and its case as two files, checked before they are written."""

from __future__ import annotations

import gzip
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from minkref.errors import Refusal
from minkref.output.documents import check_writable, refuse_overwriting
from minkref.output.output_target import refuse_stream
from minkref.verbs.certify_check import is_verified

# By whether the checker has verified it; none: it was not asked.
CHECKED = {
    True: "checked: verified",
    False: "not checked: the budget of the checker does not suffice",
    None: "not checked (--no-check)",
}


class AnyCertificate(Protocol):
    def case(self) -> str: ...

    def text(self, case: str, title: str = "", producer: str = "") -> str: ...


class Claiming(AnyCertificate, Protocol):
    @property
    def claims(self) -> Sequence[object]: ...


@dataclass(frozen=True)
class CertificateFiles:
    """FILE.cert.json, or FILE.cert.json.gz, and FILE.case.json beside it. `option`: the one that
    names the file."""

    output: Path
    case: Path
    option: str

    @classmethod
    def of(cls, output: Path, option: str) -> CertificateFiles:
        """Refuses another name."""
        refuse_stream(output, "a certificate and its case are two files", "name it FILE.cert.json")
        for ending in (".cert.json.gz", ".cert.json"):
            if output.name.endswith(ending) and output.name != ending:
                stem = output.name.removesuffix(ending)
                return cls(output, output.with_name(f"{stem}.case.json"), option)
        mend = "name it FILE.cert.json, or FILE.cert.json.gz"
        raise Refusal("this is not a name for a certificate", str(output), mend)

    def refuse(self, files: Sequence[Path]) -> None:
        """Refuses outputs that cannot be written, or would replace one of the files."""
        for path in (self.output, self.case):
            check_writable(path)
            refuse_overwriting(path, files)

    def checked(self, certificate: AnyCertificate, title: str, check: bool) -> Checked:
        """Refuses to replace a file that is not this case. Raises Refuted."""
        case = certificate.case()
        if self.case.exists() and self.case.read_bytes() != case.encode():
            mend = f"give {self.option} another name, or remove it"
            raise Refusal(
                "another file has the name of the case", str(self.case), mend, "file-exists"
            )
        text = certificate.text(self.case.name, title)
        return Checked(self, text, case, is_verified(text, case, title) if check else None)


@dataclass(frozen=True)
class Checked:
    """A certificate that may be written."""

    files: CertificateFiles
    text: str
    case: str
    verified: bool | None

    @property
    def size(self) -> int:
        """In bytes, not compressed."""
        return len(self.text.encode())

    def contents(self) -> dict[Path, bytes]:
        """The two files as they are to be written, together."""
        text = self.text.encode()
        if self.files.output.suffix == ".gz":
            text = gzip.compress(text, mtime=0)
        return {self.files.case: self.case.encode(), self.files.output: text}
