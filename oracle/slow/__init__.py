"""Exact Minkowski sums `sP + Q` in plain Python: slow, short, and sharing nothing with
`reference/`.

Start with README.md. The entry points, each exact and on rational coordinates:

- `read_operand` reads a file, `operand_from_json` what `json.loads` gives.
- `minkowski_sum` is the sum at one scale, with digest, holes, components and tight passages.
- `topology` is the sum at, just below and just above a scale.
- `witness` says how `sP` and `x - Q` meet; `check_claim` whether a given set is the sum.
"""

from .claim import Claim, check_claim
from .minkowski import Sum, minkowski_sum
from .operand import InputError, Operand, Polygon, operand_from_json
from .reader import read_operand
from .topology import Topology, topology
from .witness import Meeting, witness

__all__ = [
    "Claim",
    "InputError",
    "Meeting",
    "Operand",
    "Polygon",
    "Sum",
    "Topology",
    "check_claim",
    "minkowski_sum",
    "operand_from_json",
    "read_operand",
    "topology",
    "witness",
]
