"""Millions of events as one Parquet table."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from minkref import _core
from minkref.documents import replacing
from minkref.errors import Refusal

CHANGES = ("birth", "death", "touch", "overlap")


def write_parquet(found: _core.PairEvents, path: Path, count: int) -> None:
    """The first `count` events, a row each, in order: `s` (the exact scale, a text that is stored
    once for all events of equal scale), `s_double` (the nearest double or one beside it), `rank`,
    `kind`, `change`, and the two edges, `a_kind`, `a_edge_ring`, ... Written whole or not at all.
    Refuses without pyarrow."""
    try:
        import pyarrow.parquet
    except ImportError as error:
        raise Refusal(
            "Parquet is written by pyarrow, which is not installed",
            str(path),
            "pip install 'minkref[parquet]', or name a .json file",
            "no-pyarrow",
        ) from error
    with replacing(path) as temporary:
        pyarrow.parquet.write_table(_table(found).slice(0, count), temporary)


def _table(found: _core.PairEvents) -> Any:
    import pyarrow as pa

    count = len(found)
    raw = found.columns()

    def column(name: str, kind: Any) -> Any:
        return pa.Array.from_buffers(kind, count, [None, pa.py_buffer(raw[name])])

    begins, texts = found.scale_texts()
    distinct = len(begins) // 8 - 1
    scales = pa.Array.from_buffers(
        pa.large_string(), distinct, [None, pa.py_buffer(begins), pa.py_buffer(texts)]
    )
    rank = column("rank", pa.uint32())
    columns = {
        "s": pa.DictionaryArray.from_arrays(rank.cast(pa.int32()), scales),
        "s_double": column("scale", pa.float64()),
        "rank": rank,
        "kind": _named(column("parallel", pa.uint8()), ("pair", "parallel")),
        "change": _named(column("change", pa.uint8()), CHANGES),
    }
    edges = list(zip(*found.edges(), strict=True)) or [()] * 6
    kinds, _, *indices = edges
    for side in ("a", "b"):
        which = column(side, pa.uint32())
        columns[f"{side}_kind"] = pa.array(kinds, pa.string()).take(which).dictionary_encode()
        names = ("edge_ring", "edge", "vertex_ring", "vertex")
        for name, values in zip(names, indices, strict=True):
            columns[f"{side}_{name}"] = pa.array(values, pa.uint32()).take(which)
    return pa.table(columns)


def _named(values: Any, names: tuple[str, ...]) -> Any:
    import pyarrow as pa

    return pa.DictionaryArray.from_arrays(values.cast(pa.int8()), pa.array(names))
