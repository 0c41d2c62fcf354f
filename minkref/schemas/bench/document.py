"""The document of `bench`."""

from __future__ import annotations

from typing import Annotated, Literal

from minkref.schemas.bench.index import IndexBench
from minkref.schemas.bench.table1 import Table1
from minkref.schemas.bench.table2 import Table2
from minkref.schemas.values import Head
from msgspec import Meta


class BenchDocument(Head):
    """The document of `minkref bench --json`."""

    command: Literal["bench"]
    quick: bool
    seed: int
    table1: Annotated[
        Table1 | None,
        Meta(
            description="Polygons under uniform scaling (Table 1); null where it was not asked for."
        ),
    ]
    table2: Annotated[
        Table2 | None,
        Meta(
            description="Convex polyhedra under non-uniform scaling (Table 2); null where it was "
            "not asked for."
        ),
    ]
    index: Annotated[
        IndexBench | None,
        Meta(
            description="The index of all scales, window from 1/10 to 10, one core; null where it "
            "was not asked for."
        ),
    ]
