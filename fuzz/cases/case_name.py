"""The name of a case."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from minkref.errors import Refusal

if TYPE_CHECKING:
    from minkref.fuzz.plane.case import Case


@dataclass(frozen=True)
class CaseName:
    """A text that reproduces a case (`naming.py`), cheap to send to a worker, and the
    column of the matrix that it belongs to."""

    text: str
    group: str

    def load(self) -> Case:
        """The case in the plane. Refusal where the text names none."""
        from minkref.fuzz.cases.naming import load
        from minkref.fuzz.plane.case import Case

        case = load(self)
        if not isinstance(case, Case):
            raise Refusal("this case is in space", f"--case {self.text}", "name one in the plane")
        return case
