"""Files of a ledger: Parquet with checksums of pages, and a footer that says what they are."""

from __future__ import annotations

import io
import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, cut

FORMAT = "campaign-ledger-1"
KEY = b"minkref"  # in the metadata of a footer
ENDING = ".parquet"
REPEATED = (
    "chunk", "campaign", "setting", "question", "family", "class", "position", "flags", "scale",
    "coverage", "target", "version", "verdict", "was", "kind", "message",
)  # fmt: skip
TIMES = ("judged_at", "seconds")  # the columns in which two runs of a chunk may differ


@cache
def pyarrow() -> Any:
    """The package, which only campaigns need. Refuses without it."""
    try:
        import pyarrow as pa
        import pyarrow.parquet
    except ImportError as error:
        raise Refusal(
            "a campaign's ledger is written by pyarrow, which is not installed",
            "minkref campaign",
            "pip install 'minkref[campaign]'",
            "missing-package",
        ) from error
    return pa


@cache
def columns() -> Any:
    """The schema of parts and compacted files, in their order."""
    pa = pyarrow()
    text, word = pa.string(), pa.dictionary(pa.int32(), pa.string())
    kinds = {
        "number": pa.uint32(),
        "judged_at": pa.timestamp("ms"),
        "case": text,
        "digest": text,
        "dimension": pa.uint8(),
        "seconds": pa.float32(),
        "finding": text,
    }
    order = (
        "chunk", "campaign", "number", "judged_at", "case", "setting", "question", "family",
        "class", "position", "flags", "scale", "coverage", "dimension", "target", "version",
        "verdict", "was", "kind", "seconds", "digest", "message", "finding",
    )  # fmt: skip
    return pa.schema([(name, kinds.get(name, word)) for name in order])


@dataclass(frozen=True)
class Chunk:
    """A chunk in a footer. `cases` were judged; `absent` derived ones do not exist;
    `untaken` ones no target takes."""

    rows: int
    cases: int
    absent: int
    untaken: int


def file_of(table: Any, chunks: Mapping[str, Chunk]) -> bytes:
    """The bytes of a Parquet file with the table and a footer that names its chunks."""
    stream = io.BytesIO()
    with writer(stream, table.schema, chunks) as open_writer:
        open_writer.write_table(table)
    return stream.getvalue()


def writer(where: Any, schema: Any, chunks: Mapping[str, Chunk]) -> Any:
    """A Parquet writer with checksums of pages, whose footer names the chunks."""
    told = {
        "format": FORMAT,
        "chunks": {name: list(vars(c).values()) for name, c in chunks.items()},
    }
    text = json.dumps(told, separators=(",", ":"))
    parquet = pyarrow().parquet
    made = parquet.ParquetWriter(
        where,
        schema,
        compression="zstd",
        use_dictionary=[name for name in schema.names if name in REPEATED],
        column_encoding={"case": "DELTA_BYTE_ARRAY"} if "case" in schema.names else None,
        write_page_checksum=True,
        store_schema=False,
        write_statistics=[name for name in schema.names if name != "finding"],
    )
    made.add_key_value_metadata({KEY: text})
    return made


def parts_folder(folder: Path) -> Path:
    return folder / "ledger" / "parts"


def chunks_of(path: Path) -> dict[str, Chunk]:
    """Chunks as the footer names them. Refuses a file that is torn, or no part of a ledger."""
    pa = pyarrow()
    try:
        told = (pa.parquet.read_metadata(path).metadata or {}).get(KEY)
    except (pa.ArrowException, OSError) as error:
        raise _torn(path, f"this is no whole Parquet file: {cut(str(error))}") from error
    try:
        value: Any = json.loads(told or b"{}")
        if value.get("format") != FORMAT:
            raise ValueError("its footer does not say so")
        return {name: Chunk(*numbers) for name, numbers in value["chunks"].items()}
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise _torn(path, f"this is no file of a ledger: {error}") from error


def read_table(path: Path, wanted: Sequence[str] | None = None) -> Any:
    """The table of a file, with all checksums verified. Refuses a damaged or foreign file."""
    pa = pyarrow()
    chunks_of(path)
    try:
        table = pa.parquet.read_table(
            path,
            columns=wanted,
            page_checksum_verification=True,
            read_dictionary=list(REPEATED),
            partitioning=None,
        )
        return table.cast(pa.schema([columns().field(name) for name in table.column_names]))
    except (pa.ArrowException, OSError, KeyError) as error:
        raise _torn(path, f"this file is damaged: {cut(str(error))}") from error


def _torn(path: Path, what: str) -> Refusal:
    mend = "remove it: its chunks are run again when the campaign goes on"
    return Refusal(what, str(path), mend, "bad-ledger")


def keep_names(folder: Path) -> None:
    """Makes the names in a folder last, where the system can."""
    try:
        file = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    except OSError:
        return
    try:
        os.fsync(file)
    except OSError:
        pass
    finally:
        os.close(file)
