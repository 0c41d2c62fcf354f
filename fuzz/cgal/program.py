"""A stand-alone C++ program that shows a fault of CGAL: CGAL only, exact input, one call.

For a report to CGAL: neither the reference nor the oracle takes part.
"""

from __future__ import annotations

import json
from fractions import Fraction
from string import Template
from typing import Any

from minkref.fuzz.cgal.executables import METHODS_WITH_HOLES

Operand = str | dict[str, Any]
Point = tuple[str, str]
Ring = list[list[str]]

_STRATEGIES = {
    "vertical": ("Polygon_vertical_decomposition_2", "Polygon_vertical_decomposition_2"),
    "triangulation": ("Polygon_triangulation_decomposition_2",) * 2,
    "ssab": ("Small_side_angle_bisector_decomposition_2",) * 2,
    "optimal": ("Polygon_convex_decomposition_2", "Optimal_convex_decomposition_2"),
    "hertel-mehlhorn": ("Polygon_convex_decomposition_2", "Hertel_Mehlhorn_convex_decomposition_2"),
    "greene": ("Polygon_convex_decomposition_2", "Greene_convex_decomposition_2"),
}
_CALLS = {
    "reduced": "CGAL::minkowski_sum_by_reduced_convolution_2(P, Q)",
    "full": "CGAL::minkowski_sum_by_full_convolution_2(P, Q)",
}

_TEMPLATE = """\
// CGAL, Minkowski sum of two polygons: $METHOD.
$COMMENT//
// g++ -std=c++17 -O2 -DNDEBUG -frounding-math $NAME.cpp -o $NAME -lmpfr -lgmp && ./$NAME
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
$INCLUDES#include <CGAL/minkowski_sum_2.h>
#include <CGAL/version.h>

#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_2;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using Text = std::vector<std::vector<std::vector<const char*>>>;  // outer ring, holes; x, y

// clang-format off
const Text kP = $P;

const Text kQ = $Q;
// clang-format on

Number integer(const std::string& text) {
  Number value = 0;
  for (const char c : text) {
    if (c != '-') value = value * 10 + (c - '0');
  }
  return text[0] == '-' ? Number(-value) : value;
}

// "n" or "n/d", exactly.
Number number(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return integer(text);
  const Number value = integer(text.substr(0, slash)) / integer(text.substr(slash + 1));
  CGAL::exact(value);  // the tightest interval of doubles around it
  return value;
}

// sign * p + shift for each vertex p; a point reflection keeps the orientation.
PolygonWithHoles polygon(const Text& text, int sign, const Number& dx, const Number& dy) {
  PolygonWithHoles result;
  for (const auto& vertices : text) {
    Polygon ring;
    for (const auto& p : vertices) {
      ring.push_back(Point(sign * number(p[0]) + dx, sign * number(p[1]) + dy));
    }
    if (result.outer_boundary().is_empty()) {
      result.outer_boundary() = ring;
    } else {
      result.add_hole(ring);
    }
  }
  return result;
}
$COVERS
int main() {
  const PolygonWithHoles givenP = polygon(kP, 1, 0, 0), givenQ = polygon(kQ, 1, 0, 0);
  const auto& P = $GIVEN_P;
  const auto& Q = $GIVEN_Q;
  const PolygonWithHoles sum = $CALL;
  std::cout << "CGAL " << CGAL_STR(CGAL_VERSION) << ", $METHOD: " << sum.outer_boundary().size()
            << " vertices outside, " << sum.number_of_holes() << " holes" << std::endl;
$CHECK}
"""

_COVERS = """
// Outside the outer ring, or strictly inside a hole: no. (Rings may touch themselves.)
bool covers(const PolygonWithHoles& set, const Point& x) {
  const auto side = [&](const Polygon& ring) {
    return CGAL::bounded_side_2(ring.vertices_begin(), ring.vertices_end(), x, Kernel());
  };
  if (side(set.outer_boundary()) == CGAL::ON_UNBOUNDED_SIDE) return false;
  for (auto hole = set.holes_begin(); hole != set.holes_end(); ++hole) {
    if (side(*hole) == CGAL::ON_BOUNDED_SIDE) return false;
  }
  return true;
}
"""

_CHECK = """\
  const Point x(number("$X"), number("$Y"));
  const bool truth = $TRUTH;
  const bool in = covers(sum, x);
  std::cout << "x = ($X, $Y) in this sum: " << (in ? "in" : "out") << std::endl
            << "in truth: " << (truth ? "in" : "out") << std::endl;
  // Independently: x lies inside the sum where the interiors of P and x - Q meet, else outside or
  // on its boundary.
  const bool meet = CGAL::do_intersect(givenP, polygon(kQ, -1, x.x(), x.y()));
  std::cout << "interiors of P and x - Q, by CGAL's Boolean operations: "
            << (meet ? "they meet" : "disjoint") << std::endl;
  return in == truth ? 0 : 1;
"""


def cgal_program(
    P: Operand,
    Q: Operand,
    method: str,
    point: Point | None = None,
    in_truth: bool = False,
    *,
    raw: bool = False,
    observed: str = "",
    name: str = "fault",
) -> str:
    """Returns the text of a C++ file that computes P + Q by `method`, prints the result's hole
    count and whether `point` lies in the result ("in" or "out"), and exits with 1 if this differs
    from `in_truth`. Without a point, as for a crash, the file only makes the call.

    P is scaled already. Unless `raw`, the file omits holes that cannot survive, as the oracle does,
    and a comment names them: the remaining operands have the same sum, and the fault shown is
    CGAL's. `observed` goes into the comment. Exact. Raises ValueError for operands that CGAL's
    methods do not take."""
    rings = {"P": _rings(P), "Q": _rings(Q)}
    left_out: list[str] = []
    if not raw:
        rings["P"] = _without_vanishing_holes("P", rings["P"], rings["Q"], left_out)
        rings["Q"] = _without_vanishing_holes("Q", rings["Q"], rings["P"], left_out)
    if method not in METHODS_WITH_HOLES and (len(rings["P"]) > 1 or len(rings["Q"]) > 1):
        raise ValueError(f"{method} takes polygons without holes")
    comment = [line for line in observed.splitlines() if line] + left_out
    check = "  return 0;\n"
    if point:
        truth = "true" if in_truth else "false"
        check = Template(_CHECK).substitute(X=point[0], Y=point[1], TRUTH=truth)
    return Template(_TEMPLATE).substitute(
        METHOD=method,
        COMMENT="".join(f"// {line}\n" for line in comment),
        NAME=name,
        INCLUDES=f"#include <CGAL/{_STRATEGIES[method][0]}.h>\n" if method in _STRATEGIES else "",
        P=_literal(rings["P"]),
        Q=_literal(rings["Q"]),
        COVERS=_COVERS if point else "",
        GIVEN_P="givenP" if len(rings["P"]) > 1 else "givenP.outer_boundary()",
        GIVEN_Q="givenQ" if len(rings["Q"]) > 1 else "givenQ.outer_boundary()",
        CALL=_call(method),
        CHECK=check,
    )


def _call(method: str) -> str:
    if method in _CALLS:
        return _CALLS[method]
    return f"CGAL::minkowski_sum_2(P, Q, CGAL::{_STRATEGIES[method][1]}<Kernel>())"


def _rings(operand: Operand) -> list[Ring]:
    value = json.loads(operand) if isinstance(operand, str) else operand
    if len(value["polygons"]) != 1:
        raise ValueError(f"{len(value['polygons'])} polygons: CGAL's methods take one")
    polygon = value["polygons"][0]
    return [polygon["outer"], *polygon.get("holes", [])]


def _extent(ring: Ring) -> tuple[Fraction, Fraction]:
    xs = [Fraction(x) for x, _ in ring]
    ys = [Fraction(y) for _, y in ring]
    return max(xs) - min(xs), max(ys) - min(ys)


def _without_vanishing_holes(
    name: str, rings: list[Ring], other: list[Ring], left_out: list[str]
) -> list[Ring]:
    """The rings less each hole no wider or no higher than the other operand: that does not fit
    strictly inside, so no translate of it avoids this operand within the hole."""
    width, height = _extent(other[0])
    kept = [rings[0]]
    for number, hole in enumerate(rings[1:], start=1):
        hole_width, hole_height = _extent(hole)
        if hole_width > width and hole_height > height:
            kept.append(hole)
            continue
        corner = ", ".join(hole[0])
        left_out.append(
            f"Left out: hole {number} of {name}, at ({corner}), {hole_width} by {hole_height}. The "
            f"other polygon, {width} by {height}, does not fit inside: the sum is the same without."
        )
    return kept


def _literal(rings: list[Ring]) -> str:
    """A C++ initialiser, a ring on lines of at most some 90 characters."""
    texts = []
    for ring in rings:
        lines = [""]
        for x, y in ring:
            vertex = f'{{"{x}", "{y}"}}, '
            if lines[-1] and len(lines[-1]) + len(vertex) > 90:
                lines.append("")
            lines[-1] += vertex
        texts.append("    {" + "\n     ".join(line.rstrip() for line in lines).rstrip(",") + "}")
    return "{\n" + ",\n".join(texts) + "}"
