"""Values of JSON with one part replaced."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from functools import reduce
from operator import getitem
from typing import Any


def replaced(value: Any, path: Sequence[Any], new: Any) -> Any:
    """A copy in which something else is at the end of the path."""
    if not path:
        return new
    made = copy.deepcopy(value)
    reduce(getitem, path[:-1], made)[path[-1]] = new
    return made
