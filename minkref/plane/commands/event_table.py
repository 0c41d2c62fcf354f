"""Millions of events as one Parquet table."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from minkref import _core
from minkref.cli.progress import progress
from minkref.errors import Refusal
from minkref.output.documents import replacing

MANY_VALUES = ("s_double", "rank")  # hardly any of which is there twice
CHANGES = ("birth", "death", "touch", "overlap")


ROWS = 1 << 18  # that are in memory, and in one group of the file


def write_parquet(found: _core.PairEvents, path: Path, count: int) -> None:
    """The first `count` events, a row each, in order: `s` (the exact scale, a text that is stored
    once for all events of equal scale), `s_double` (the nearest double), `rank`,
    `kind`, `change`, and the two edges, `a_kind`, `a_edge_ring`, ... Written whole or not at all,
    group by group. Refuses without pyarrow."""
    try:
        import pyarrow.parquet as parquet
    except ImportError as error:
        raise Refusal(
            "Parquet is written by pyarrow, which is not installed",
            str(path),
            "pip install 'minkref[parquet]', or name a .json file",
            "no-pyarrow",
        ) from error
    count = min(count, len(found))
    edges = _edge_columns(found)
    with replacing(path) as temporary, progress(count) as line:
        first = _table(found, edges, 0, min(ROWS, count))
        repeated = [name for name in first.column_names if name not in MANY_VALUES]
        with parquet.ParquetWriter(temporary, first.schema, use_dictionary=repeated) as writer:
            line.now("writing events")
            writer.write_table(first)
            for begin in range(ROWS, count, ROWS):
                line.done(ROWS)
                writer.write_table(_table(found, edges, begin, min(begin + ROWS, count)))


def _edge_columns(found: _core.PairEvents) -> dict[str, Any]:
    """The columns of all edges; events take their rows from these columns."""
    import pyarrow as pa

    kinds, _, *indices = list(zip(*found.edges(), strict=True)) or [()] * 6
    columns = {"kind": pa.array(kinds, pa.string())}
    names = ("edge_ring", "edge", "vertex_ring", "vertex")
    for name, values in zip(names, indices, strict=True):
        columns[name] = pa.array(values, pa.uint32())
    return columns


def _table(found: _core.PairEvents, edges: dict[str, Any], first: int, last: int) -> Any:
    import pyarrow as pa

    raw = found.columns(first, last)

    def column(name: str, kind: Any) -> Any:
        return pa.Array.from_buffers(kind, last - first, [None, pa.py_buffer(raw[name])])

    begins, texts, nearest, which = found.scale_texts(first, last)
    buffers = [None, pa.py_buffer(begins), pa.py_buffer(texts)]
    scales = pa.Array.from_buffers(pa.large_string(), len(begins) // 8 - 1, buffers)
    doubles = pa.Array.from_buffers(pa.float64(), len(scales), [None, pa.py_buffer(nearest)])
    places = pa.Array.from_buffers(pa.int32(), last - first, [None, pa.py_buffer(which)])
    columns = {
        "s": pa.DictionaryArray.from_arrays(places, scales),
        "s_double": doubles.take(places),
        "rank": column("rank", pa.uint32()),
        "kind": _named(column("parallel", pa.uint8()), ("pair", "parallel")),
        "change": _named(column("change", pa.uint8()), CHANGES),
    }
    for side in ("a", "b"):
        edge = column(side, pa.uint32())
        for name, values in edges.items():
            taken = values.take(edge)
            columns[f"{side}_{name}"] = taken.dictionary_encode() if name == "kind" else taken
    return pa.table(columns)


def _named(values: Any, names: tuple[str, ...]) -> Any:
    import pyarrow as pa

    return pa.DictionaryArray.from_arrays(values.cast(pa.int8()), pa.array(names))
