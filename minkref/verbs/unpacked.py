"""Certificates and cases that may be compressed by gzip: the checkers take plain JSON."""

from __future__ import annotations

import zlib
from pathlib import Path

from minkref.oracle.checker import check as checker


class Unpacking:
    """Reads a certificate and its case for the checker in Python, and gives both to another one."""

    def __init__(self) -> None:
        self.read: list[tuple[Path, bytes | None]] = []  # with what was unpacked

    def __call__(self, path: Path, most: float) -> bytes:
        """The plain bytes, one more than `most` where there are too many. Raises NotVerified."""
        return self._kept(path, checker.file_bytes(path, most), most)

    def certificate(self, path: Path, most: float) -> bytes:
        """The same of a certificate: `-` is standard input."""
        if str(path) != "-":
            return self(path, most)
        return self._kept(path, checker.INPUT[0](path, most), most)

    def _kept(self, path: Path, data: bytes, most: float) -> bytes:
        packed = data[:2] == checker.GZIP and len(data) <= most
        data = plain(data, path, int(most)) if packed else data
        self.read.append((path, data if packed or str(path) == "-" else None))
        return data

    def files(self, folder: Path) -> list[Path]:
        """The plain files in the order of reading; those that were compressed are in `folder`."""
        found = []
        for at, (path, data) in enumerate(self.read):
            found.append(path if data is None else folder / f"{at}.json")
            if data is not None:
                found[-1].write_bytes(data)
        return found


def plain(data: bytes, path: Path, most: int) -> bytes:
    """What one member of gzip holds, with nothing after it, and no more than a byte beyond the
    limit: a bomb stays packed. Raises NotVerified."""
    packed = zlib.decompressobj(wbits=31)
    try:
        found = packed.decompress(data, most + 1)
    except zlib.error as error:
        raise checker.NotVerified(checker.MALFORMED, f"{path} is not JSON: {error}") from error
    whole = len(found) > most or (packed.eof and not packed.unused_data)
    checker.require(whole, f"{path} is not one whole compressed file")
    return found
