"""Exact Minkowski sums `sP + Q` in plain Python: slow, short, and independent from `reference/`.

Start with README.md. The entry points are exact, on rational coordinates:

- `read_operand` reads a file, `operand_from_json` reads a value from `json.loads`.
- `minkowski_sum` computes the sum at one scale, with digest, holes, components, tight passages.
- `topology` computes the sum at, just below and just above a scale.
- `witness` tells how `sP` and `x - Q` meet; `check_claim` compares a given set with the sum.
- For space, `SolidSum` answers questions about points, `whole_sum` computes a small sum completely,
  `solid_faults` tests a claim on points, and `CellSum` sums polycubes under a matrix.
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
