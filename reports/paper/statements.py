"""Each equation, observation, theorem, table and figure from the paper's Sections 1 and 3 to 8 and
its Appendix: the place in the project, the form, and the command that shows the statement."""

from __future__ import annotations

from dataclasses import dataclass

EXACT = "rational"
FOUR = "rational, interval, double, MPFR"
ROUNDED_ROOTS = "rational with roots, double, MPFR"
TWO = "double, MPFR"
NONE = "-"
PRINTED, CORRECTED, BOTH = "printed", "corrected", "printed, corrected"

AUDIT = "minkref report audit"
PAPER = "minkref report paper"
SWEEP = "minkref sweep g3 g1 --from 1 --to 2 --steps 3 --route paper-update"
SUM = "minkref sum g3 g1 --scale 7/5 --route paper-update"
REPAIR = "minkref sweep gs3 rod --scales scalings.txt --repair literal"

SOLID_SUM = "minkref sum solid.off solid.off --scale 3/2 --route paper-update"
SOLIDS = "minkref events solid.off solid.off --from 1/2 --to 2"
ROOM = "minkref {} part.wkt room.wkt"

CRITICAL, PLANE = "reference/plane/critical", "reference/plane"
PAPER_PLANE = "reference/paper/plane"
DISC_PAIRS = "minkref events g1 disc --kind pair"
CONTACTS, CHECKED = "reference/space/critical", "places of small grids (`oracle/sampled`)"
MOTION = "reference/motion"
PAIRS, DIAGRAM = "reference/disc/pairs", "reference/disc/diagram"
FEATURES = "reference/disc/features"
APPENDIX_PROGRAM = "reference/paper/disc"
CONVEX, LITERAL = "reference/space/convex", "reference/paper/space"
REPORT, BENCH = "reports/paper", "reports/bench"


@dataclass(frozen=True)
class Statement:
    """`files`: files from reference/, or from reports/ for measuring and drawing. `judge`: the
    standard for comparison. `entries`: audit entries about the statement. `theorems`: statements of
    oracle/proved/theory/Paper.v, each proved or refuted there."""

    place: str
    what: str
    files: tuple[str, ...]
    form: str
    arithmetics: str
    command: str
    judge: str
    entries: tuple[str, ...] = ()
    theorems: tuple[str, ...] = ()


ALGEBRA = "computer algebra"
SLOW = "the sum from the definition (`oracle/slow`)"
SYMBOLIC = "events by computer algebra (`oracle/symbolic`)"
EXACT_SUM = "the exact sum, a point where they differ"
EXACT_FACETS = "the facets of the exact sum"
COUNT = "a count from the rule"
SUPPORTS = "compatible pairs by supports alone"
OWN_NUMBERS = "the printed numbers"
SAME_RUN = "both sides timed in one run"
CLAIMS = "its sentences on the page, by the rule there"

SECTION_1 = (
    Statement("1", r"$P \oplus Q = \{p + q\}$", (f"{PLANE}/sum.hpp",), PRINTED, FOUR,
              "minkref sum g3 g1", SLOW),
    Statement("1", r"$v' = (s_1 v_1, \ldots, s_d v_d)$, $s_i \in (0, \infty)$",
              (f"{PLANE}/polygon_set.hpp", f"{CONVEX}/convex_polyhedron.hpp"), CORRECTED, EXACT,
              "minkref sum gs3 rod --scale 2,1/3,5", SLOW, ("range-of-scales",)),
    Statement("1", "intersections change only at finitely many scales, the critical events",
              (f"{CRITICAL}/pair_events.hpp", f"{PLANE}/dynamic/triple_events.hpp"), CORRECTED,
              EXACT, "minkref events g3 g1 --kind arrangement", SYMBOLIC, ("events-of-pairs",)),
    Statement("Fig. 1", "sums and convolutions of neuron and disc at two scales",
              (f"{REPORT}/drawings.py",), CORRECTED, EXACT, PAPER, CLAIMS, ("orientation",)),
)  # fmt: skip

SECTION_3 = (
    Statement("3", r"$P \oplus Q \subseteq P \otimes Q$, $\partial (P \oplus Q) = \partial (P "
              r"\otimes Q)$", (f"{PLANE}/convolution/convolution.hpp",), CORRECTED, EXACT,
              "minkref convolution g3 g1 --full", SLOW, ("sum-in-convolution",),
              ("boundary_in_reduced_convolution",)),
    Statement("3", "an edge and a vertex are compatible: its direction is on the turn at it",
              (f"{PLANE}/convolution/convolution_rule.hpp", f"{PLANE}/convolution/between.hpp"),
              BOTH, EXACT, "minkref convolution g3 g1 --compatible closed", COUNT, ("between",),
              ("boundary_in_reduced_convolution", "incompatible_vertices_contribute_nothing")),
    Statement("3", "a facet and a vertex, or two edges, are compatible: their Gaussian maps meet",
              (f"{CONVEX}/compatibility.hpp",), CORRECTED, EXACT, "minkref convolution gs3 rod",
              SUPPORTS, ("reflex-edges",)),
    Statement("3", "the reduced convolution leaves out reflex vertices",
              (f"{PLANE}/convolution/convolution.hpp",), CORRECTED, EXACT,
              "minkref convolution g3 g1", SLOW, ("reflex-vertices", "straight-vertices"),
              ("reflex_vertices_contribute_nothing",)),
    Statement("3", "cells with winding numbers that are not zero (earlier work)",
              (f"{PLANE}/routes/routes.hpp",), CORRECTED, EXACT,
              "minkref sum g3 g1 --route winding", SLOW,
              ("winding-numbers", "reduced-is-no-cycle")),
    Statement("3", "the updates serve any method based on the convolution",
              ("reference/plane/dynamic/winding_status.hpp",), CORRECTED, EXACT,
              "minkref sweep g1 g2 --from 1 --to 2 --steps 5 --route winding",
              "the sum from scratch, and its winding numbers", ("updates-by-winding-numbers",)),
    Statement("3", "nested orientable loops, and collision detection",
              (f"{PLANE}/routes/paper_route.hpp", f"{PLANE}/routes/collision.hpp"), CORRECTED,
              FOUR, "minkref sum g3 g1 --route paper", SLOW, ("orientable-loops",)),
    Statement("3", "$O(m^d n^d)$ in the worst case", (f"{PLANE}/convolution/convolution_size.hpp",),
              PRINTED, EXACT, AUDIT, "a family that has as many holes", ("worst-case",)),
    Statement("3", "far fewer primitives than sums of pairs of parts",
              (f"{PLANE}/convolution/convolution_size.hpp",), PRINTED, EXACT, AUDIT, COUNT,
              ("fewer-primitives",)),
    Statement("3", "the reduced convolution is much faster than Wein's method",
              ("oracle/cgal/reduced.cpp", "oracle/cgal/full.cpp"), "CGAL's", EXACT, AUDIT,
              SAME_RUN, ("faster-than-winding",)),
    Statement("Fig. 2", "two polygons, their convolution and reduced convolution",
              (f"{REPORT}/drawings.py",), CORRECTED, EXACT, PAPER, CLAIMS),
)  # fmt: skip

SECTION_4 = (
    Statement("4", "the combinatorial structure is the same at all scales",
              (f"{PLANE}/convolution/convolution.hpp",), PRINTED, EXACT,
              "minkref convolution g3 g1 --scale 7/5", COUNT, ("constant-convolution",)),
    Statement("4.1", r"$a(s) = s e_p + v_q$ (S-edges), $a(s) = e_q + s v_p$ (T-edges)",
              (f"{PLANE}/moving/moving_edge.hpp",), PRINTED, FOUR,
              "minkref convolution g3 g1 --scale 2", ALGEBRA, ("constant-convolution",)),
    Statement("Fig. 3", "a T-edge and an S-edge, and how their intersections move",
              (f"{REPORT}/moving_edges_drawn.py",), PRINTED, EXACT, PAPER, CLAIMS),
    Statement("4.1, Observation 1", r"$r_I = \frac{v_y u_x - v_x u_x}{v_x w_y - v_y w_x}$, $x = "
              r"a_0 + r_I v$", (f"{CRITICAL}/line_intersection.hpp",), BOTH, FOUR,
              f"{SUM} --form corrected --reading observation=printed", f"{ALGEBRA}; {EXACT_SUM}",
              ("intersection-parameter", "parallel-lines"),
              ("observation_1", "observation_1_printed")),
    Statement("4.2", r"$x(s) = x_0 + (s - 1) \sigma$, $\sigma = x(2) - x(1)$",
              (f"{CRITICAL}/line_intersection.hpp",), PRINTED, FOUR, f"{SWEEP} --form corrected",
              f"{ALGEBRA}; {EXACT_SUM}", ("moving-intersection",),
              ("crossings_move_linearly",)),
    Statement("4.2", "first and last contact are at an end of an edge",
              (f"{CRITICAL}/pair_events.hpp",), PRINTED, EXACT, "minkref events g3 g1", SYMBOLIC,
              ("contact-at-an-end",)),
    Statement("4.2.1", r"S-edge: $s \alpha = \beta$ with $\alpha = e_{p_0} - \sigma$, $\beta = x_0 "
              r"- \sigma - v_q$", (f"{CRITICAL}/pair_conditions.hpp",), PRINTED, FOUR,
              f"{SWEEP} --form corrected --arithmetic double", f"{ALGEBRA}; {EXACT_SUM}",
              ("conditions-of-ends",)),
    Statement("4.2.1", "the system is overdetermined: no solution if it is inconsistent",
              (f"{CRITICAL}/scale_solve.hpp",), "printed, tolerance, least squares, corrected",
              FOUR, f"{SUM} --form corrected --reading solve=printed --arithmetic mpfr:100",
              EXACT_SUM, ("overdetermined",)),
    Statement("4.2.2", "T-edge: $x_0 + (s - 1) \\sigma = e_{q_i} + s v_p$",
              (f"{CRITICAL}/pair_conditions.hpp",), PRINTED, FOUR,
              f"{SWEEP} --form corrected --arithmetic mpfr:53", f"{ALGEBRA}; {EXACT_SUM}",
              ("conditions-of-ends",)),
    Statement("4.2.3", r"$[\max\{B_{a_0}, B_{b_0}\}, \min\{B_{a_1}, B_{b_1}\}]$",
              (f"{CRITICAL}/pair_interval.hpp", f"{PAPER_PLANE}/critical_regions.hpp"), BOTH, FOUR,
              "minkref events g3 g1 --form printed", SYMBOLIC,
              ("interval-of-a-pair", "interval-invented", "interval-sorted",
               "interval-for-convex-p", "share-of-right-intervals"),
              ("interval_of_a_pair", "interval_printed")),
    Statement("4.2.3", "all intervals in $O(n^2)$", (f"{PAPER_PLANE}/region_search.hpp",), PRINTED,
              FOUR, f"{SUM} --form corrected --json", "the pairs that it counts",
              ("size-of-preprocessing",)),
    Statement("4.2.4", "stepping through the array of events, then updating all nodes",
              (f"{PAPER_PLANE}/paper_update.hpp", f"{PAPER_PLANE}/intersection_lists.hpp"),
              "intersections kept in order, or sorted", FOUR,
              f"{SWEEP} --form corrected --reading order=kept", EXACT_SUM,
              ("upwards-only", "simultaneous-events")),
)  # fmt: skip

SECTION_5 = (
    Statement("5", "in space an event is a contact of two faces: at a vertex, or of two edges",
              (f"{CONTACTS}/facet_event.hpp", f"{CONTACTS}/critical_events.hpp"), CORRECTED, EXACT,
              SOLIDS, SYMBOLIC, ("contacts-of-facets", "four-facets")),
    Statement("5.1", r"$x(s) = x_0 + (s - 1) \sigma$, set equal to $e_i(s)$; inside the face",
              (f"{CONTACTS}/facet_event.hpp", f"{LITERAL}/facet_contacts.hpp"), BOTH, FOUR,
              f"{SOLIDS} --form printed --arithmetic double", SYMBOLIC,
              ("moving-intersection-in-space", "overdetermined-in-space")),
    Statement("5.2", r"$e_a - t_a = (e_a - e_b, t_b - t_a, t_c - t_a)^T (t, u, v)$, hence $x_1 = "
              r"x_2$ for two edges",
              (f"{CONTACTS}/facet_event.hpp", f"{LITERAL}/two_facets.hpp"), BOTH, FOUR,
              f"{SOLIDS} --form corrected --arithmetic mpfr:53", SYMBOLIC,
              ("line-and-plane", "edge-events", "singular-systems", "inside-both",
               "facets-in-triangles")),
    Statement("5.2", "parallel faces meet at the one scale at which they are coplanar",
              (f"{CONTACTS}/parallel_facets.hpp", f"{LITERAL}/facet_contacts.hpp"), BOTH, FOUR,
              f"{SOLIDS} --reading corner=lines", SYMBOLIC,
              ("parallel-faces", "vertex-events-of-parallel-faces")),
    Statement("5.2", "faces that are always coplanar are a case of the plane",
              (f"{CONTACTS}/parallel_facets.hpp", f"{LITERAL}/coplanar_sides.hpp"), BOTH, FOUR,
              f"{SOLIDS} --form printed --reading coplanar=dropped", SYMBOLIC,
              ("coplanar-faces",)),
    Statement("5", "the array of events in space, stepped through; all crossings placed",
              (f"{LITERAL}/paper_space_update.hpp", f"{LITERAL}/crossings.hpp"), BOTH, FOUR,
              f"{SOLID_SUM} --form corrected --arithmetic double",
              "the exact sum, a point of a facet where they differ", ("contacts-of-facets",)),
    Statement("5.1", "intersection points are checked to lie in the face",
              (f"{LITERAL}/update_readings.hpp",), BOTH, FOUR,
              f"{SOLID_SUM} --form corrected --reading bounds=checked --arithmetic mpfr:100",
              "the exact sum, a point of a facet where they differ", ("inside-both",)),
    Statement("Fig. 4", "six contacts of parallel faces, none of a vertex",
              (f"{REPORT}/space_drawn.py",), PRINTED, EXACT, PAPER, CLAIMS, ("parallel-faces",)),
)  # fmt: skip

SECTION_6 = (
    Statement("6", "$O(m^4 n^4)$ events", (f"{CRITICAL}/pair_events.hpp",), PRINTED, EXACT, AUDIT,
              "a count", ("event-space",)),
    Statement("6", "a facet and a vertex are compatible: its edges are below the facet",
              (f"{CONVEX}/facet_contact.hpp",), CORRECTED, EXACT, "minkref convolution gs3 rod",
              SUPPORTS, ("normals-after-scaling",)),
    Statement("6", r"$IC(f, v) = \max\{d(e, f)\}$, and descent on it",
              (f"{CONVEX}/incompatibility.hpp", f"{LITERAL}/normals_and_edges.hpp"), BOTH, FOUR,
              f"{REPAIR} --form corrected --reading degree=printed --trace", EXACT_FACETS,
              ("degree-of-incompatibility", "descent")),
    Statement("6", "fv-errors are repaired by descent, ee-errors by chains",
              (f"{LITERAL}/paper_repair.hpp", f"{CONVEX}/dynamic_convex_sum.hpp"), BOTH, FOUR,
              REPAIR, EXACT_FACETS, ("chain-of-edges", "chain-through-a-normal")),
    Statement("6", "$O(m + n)$ facets of one kind, $O(m n)$ of the other",
              (f"{CONVEX}/sum_vertices.hpp",), PRINTED, EXACT, AUDIT, COUNT,
              ("facets-of-convex-sums",)),
    Statement("6", "each face is paired with precisely one vertex",
              (f"{CONVEX}/compatibility.hpp",), CORRECTED, EXACT, "minkref convolution gs3 ti",
              SUPPORTS, ("one-vertex-for-each-face",)),
    Statement("6, Theorem 1", "fv-errors and ee-errors coexist",
              (f"{LITERAL}/repair_readings.hpp", f"{CONVEX}/dynamic_convex_sum.hpp"),
              "facets of P alone, or of both", FOUR,
              f"{REPAIR} --form corrected --reading errors=facets-of-P", EXACT_FACETS,
              ("theorem-1-one-kind", "theorem-1-edge-errors", "theorem-1-facet-errors",
               "theorem-1-proof", "theorem-1-entangled"),
              ("theorem_1_second_half", "all_facets_may_change_and_no_edges")),
    Statement("6", r"$O(\lvert E \rvert)$ for the chain of an edge",
              (f"{LITERAL}/paper_repair.hpp",), PRINTED, EXACT, AUDIT,
              "a count of the edges that are looked at", ("cost-of-a-chain",)),
    Statement("Fig. 5", "the degree of incompatibility, and the chain of an edge",
              (f"{REPORT}/space_drawn.py",), CORRECTED, EXACT, PAPER, CLAIMS),
)  # fmt: skip

SECTION_7 = (
    Statement("7", "exact algorithms, in MPFR", (f"{PAPER_PLANE}/paper_update.hpp",), PRINTED, FOUR,
              f"{SUM} --form corrected --arithmetic mpfr:100", EXACT_SUM, ("exact-arithmetic",)),
    Statement("Fig. 6", "five small polygons", (f"{REPORT}/drawings.py",), "ours", EXACT, PAPER,
              CLAIMS),
    Statement("Table 1", "average speed-ups of 25 pairs",
              (f"{PAPER_PLANE}/intersections_afresh.hpp", f"{BENCH}/table1.py"), CORRECTED, TWO,
              "minkref bench --only table1", SAME_RUN,
              ("table-1-mean", "table-1-largest", "table-1-symmetry", "orders-of-magnitude")),
    Statement("7.1", "16,425 and 3,196 edges", (f"{PLANE}/convolution/convolution_size.hpp",),
              CORRECTED, EXACT, AUDIT, COUNT,
              ("edges-of-monkey-and-bird", "edges-of-neuron-and-disc")),
    Statement("7.1", "56,996,430 and 56,238 events", (f"{CRITICAL}/pair_events.hpp",), CORRECTED,
              EXACT, AUDIT, SYMBOLIC, ("events-of-both-pairs",)),
    Statement("Fig. 7", "speed-up of monkey and bird against events and intersections",
              (f"{PAPER_PLANE}/paper_update.hpp", f"{REPORT}/speedups.py"), CORRECTED, "double",
              PAPER, SAME_RUN, ("captions", "events-outstrip-intersections")),
    Statement("Fig. 8", "the same of neuron and disc",
              (f"{PAPER_PLANE}/paper_update.hpp", f"{REPORT}/speedups.py"), CORRECTED, TWO, PAPER,
              SAME_RUN, ("figure-8-axis",)),
    Statement("7.1", r"$\Theta(n \log n)$ at best for the static intersections",
              (f"{PLANE}/arrangement/segment_contacts.hpp",), PRINTED, EXACT, AUDIT, "an argument",
              ("static-bound",)),
    Statement("7.1", "140 s and 28.7 s, 5.3 s and 1.25 s for nodes and events",
              (f"{PAPER_PLANE}/intersections_afresh.hpp", f"{CRITICAL}/pair_events.hpp"),
              CORRECTED, TWO, PAPER, SAME_RUN, ("repeated-paragraph",)),
    Statement("Fig. 9", "knot and clutch: events on [0.2, 2], speed-up of the intersections and "
              "of the whole",
              (f"{LITERAL}/paper_space_update.hpp", f"{REPORT}/space_times.py",
               "reference/space/critical/crossing_facets.hpp"), CORRECTED,
              "double, MPFR, rational", PAPER, SAME_RUN,
              ("captions", "events-in-space")),
    Statement("7.2.1", "collision detection takes about half of the time in space",
              ("reference/space/edges/collision.hpp",), CORRECTED, EXACT, AUDIT, "a clock",
              ("collision-detection-in-space",)),
    Statement("Fig. 10", "five convex polyhedra", (f"{CONVEX}/convex_polyhedron.hpp",), "ours",
              EXACT, "minkref models", COUNT, ("facets-of-models",)),
    Statement("7.2.2", "uniform scaling of convex models scales their sums",
              (f"{CONVEX}/static_convex_sum.hpp",), CORRECTED, EXACT,
              "minkref sum gs3 rod --scale 2", SUPPORTS,
              ("uniform-scaling-of-convex-bodies", "boundary-of-convex-sums")),
    Statement("Table 2", "average speed-ups of 25 pairs of convex polyhedra",
              (f"{CONVEX}/dynamic_convex_sum.hpp", f"{BENCH}/table2.py"), CORRECTED, EXACT,
              "minkref bench --only table2", SAME_RUN, ("table-2-range", "no-collision-detection")),
)  # fmt: skip

SECTION_8 = (
    Statement("8.1", "the largest scale for which a path is valid: first contact with an obstacle",
              (f"{MOTION}/valid_scales.hpp", f"{MOTION}/path_edges.hpp"), CORRECTED, EXACT,
              f"{ROOM.format('path')} 'LINESTRING (3 3, 12 3)'", CHECKED,
              ("largest-valid-scale", "touching-on-a-path", "path-starts-inside")),
    Statement("8.1", "events of the path, easier than those of the convolution",
              (f"{MOTION}/path_edges.hpp",), CORRECTED, EXACT,
              f"{ROOM.format('path')} 'LINESTRING (3 3, 12 3)' --route contacts", SYMBOLIC,
              ("path-events",)),
    Statement("8.1", "the largest scale of a part that fits into the assembly",
              (f"{MOTION}/fits_and_traps.hpp",), CORRECTED, EXACT,
              "minkref fit disc1 g1 --anywhere", CHECKED),
    Statement("8.1", "the smallest scale at which the assembly traps the part",
              (f"{MOTION}/fits_and_traps.hpp",), CORRECTED, EXACT,
              f"{ROOM.format('trap')} --at 3,3", CHECKED, ("trapping-scale",)),
    Statement("Fig. 11", "repeated obstacles: 96.811 ms and 2.498 ms",
              (f"{BENCH}/repeated_obstacles.py",), CORRECTED, "double, mpfr:53",
              "minkref report paper", SAME_RUN, ("speed-up-of-figure-11",)),
    Statement("8.2", r"$\alpha$-discs and $\alpha$-bridges, at all $\alpha$",
              (f"{DIAGRAM}/diagram_events.hpp",), "corrected, as corners of sums with a disc",
              EXACT, "minkref events g1 disc", SYMBOLIC,
              ("alpha-of-a-disc", "bridges-end-at-triple-events", "limits-of-alpha")),
    Statement("8.2", "persistence of bridges, as lengths on the Voronoi complex",
              (f"{FEATURES}/tracks.hpp", f"{FEATURES}/barcode.hpp"),
              "corrected, as lives in $\\alpha$", EXACT, "minkref features beetle",
              f"{ALGEBRA}; trees and bars: oracle/features", ("persistence-of-bridges",)),
    Statement("Fig. 12", "pocket minima and a decomposition of a beetle",
              (f"{FEATURES}/feature_level.hpp", "reference/plane/decomposition/notch_cuts.hpp",
               f"{BENCH}/growing_disc.py"),
              "by definitions of our own; the intersections also by the Appendix's program",
              "exact; double, mpfr:53",
              "minkref decompose beetle --from 1/20 --to 1 --persistence 3/5",
              "oracle/features; the rule of cuts in fractions", ("speed-up-of-figure-12",)),
)  # fmt: skip

APPENDIX = (
    Statement("Appendix", r"$p(s) = p + (s - 1) r (\perp l)$, with the same centre $c$",
              (f"{PAIRS}/offset_feature.hpp", f"{APPENDIX_PROGRAM}/moving_feature.hpp"), BOTH,
              ROUNDED_ROOTS, "minkref convolution g1 disc:7/5", ALGEBRA,
              ("disc-centre", "disc-moving-edges")),
    Statement("Appendix", "the crossing of two segments comes to an end: exactly two events, or "
              "none; those with $0 < t$ or $t > 1$ are rejected",
              (f"{PAIRS}/pair_contact.hpp", f"{PAIRS}/feature_pair.hpp",
               f"{APPENDIX_PROGRAM}/two_segments.hpp"), BOTH, ROUNDED_ROOTS,
              f"{DISC_PAIRS} --form printed", SYMBOLIC,
              ("disc-two-events", "disc-rejected-parameters", "disc-parallel-edges",
               "disc-degree-of-scales")),
    Statement("Appendix", "circles touch in the middle of their centres",
              (f"{PAIRS}/pair_contact.hpp",), PRINTED, EXACT, DISC_PAIRS, SYMBOLIC,
              ("disc-circles-touch",)),
    Statement("Appendix", r"$I(s) = M(s) (\pm \perp (c_1, c_2))$, $M(s) = \sqrt{(s^2 - s_0^2) r} + "
              r"y_{c_1}$, set equal to ends of arcs",
              (f"{PAIRS}/feature_pair.hpp", f"{APPENDIX_PROGRAM}/two_arcs.hpp"), BOTH,
              ROUNDED_ROOTS, "minkref sum g1 disc:7/5 --route paper-update --form corrected "
              "--reading radical=printed", SYMBOLIC,
              ("disc-magnitude", "disc-crossing-of-circles", "disc-ends-of-arcs",
               "disc-events-of-arcs")),
    Statement("Appendix", r"a circle touches the line of a segment at $s_0$, and crosses the line "
              r"$x_0 = x_c - s_0 r$ after",
              (f"{PAIRS}/pair_contact.hpp", f"{APPENDIX_PROGRAM}/arc_and_segment.hpp"), BOTH,
              ROUNDED_ROOTS, "minkref sum g1 disc:7/5 --route paper-update --form corrected "
              "--reading line=printed", SYMBOLIC, ("disc-tangent-line", "disc-line-moves")),
    Statement("Appendix", "the events are used to update the convolution as in Section 4",
              (f"{APPENDIX_PROGRAM}/disc_update.hpp",), BOTH, ROUNDED_ROOTS,
              "minkref sweep g1 disc:3/2 --from 1 --to 3 --steps 3 --route paper-update "
              "--form corrected", EXACT_SUM, ("disc-kinds-of-events",)),
    Statement("Appendix", "events of two arcs or segments are all events",
              (f"{PAIRS}/pair_events.hpp", f"{DIAGRAM}/diagram_events.hpp"), CORRECTED, EXACT,
              "minkref events g1 disc", SYMBOLIC, ("disc-kinds-of-events", "disc-triple-events")),
)  # fmt: skip

STATEMENTS: tuple[Statement, ...] = (
    *SECTION_1, *SECTION_3, *SECTION_4, *SECTION_5, *SECTION_6, *SECTION_7, *SECTION_8, *APPENDIX
)  # fmt: skip
