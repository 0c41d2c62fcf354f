"""Exact Minkowski sums `sP + Q` in plain Python: slow, short, and sharing nothing with
`reference/`.

Start with README.md. The entry points, each exact and on rational coordinates:

- `read_operand` reads a file, `operand_from_json` what `json.loads` gives.
- `minkowski_sum` is the sum at one scale, with digest, holes, components and tight passages.
- `topology` is the sum at, just below and just above a scale.
- `witness` says how `sP` and `x - Q` meet; `check_claim` whether a given set is the sum.
- In space `SolidSum` answers for points, `whole_sum` gives a small sum whole, `solid_faults` holds
  a claim against points, and `CellSum` is the sum of polycubes under a matrix.
"""

from .claim import Claim, check_claim
from .minkowski import Sum, minkowski_sum
from .operand import InputError, Operand, Polygon, operand_from_json
from .reader import read_operand
from .space.exposed import Exposed, exposed_from_json, of_faces
from .space.solid import Solid, solid_from_json
from .space.solid_cells import CellSum
from .space.solid_claim import Fault, open_lines
from .space.solid_claim import faults as solid_faults
from .space.solid_sum import SolidSum, uniform
from .space.solid_whole import whole_sum
from .topology import Topology, topology
from .witness import Meeting, witness

__all__ = [
    "CellSum",
    "Claim",
    "Exposed",
    "Fault",
    "InputError",
    "Meeting",
    "Operand",
    "Polygon",
    "Solid",
    "SolidSum",
    "Sum",
    "Topology",
    "check_claim",
    "exposed_from_json",
    "minkowski_sum",
    "of_faces",
    "open_lines",
    "operand_from_json",
    "read_operand",
    "solid_faults",
    "solid_from_json",
    "topology",
    "uniform",
    "whole_sum",
    "witness",
]
