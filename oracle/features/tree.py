"""The merge tree, and bars by the elder rule."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cmp_to_key
from typing import Literal

from .chord import chord_at, depth
from .levels import Levels, Sets
from .number import Number, number, order
from .outline import primitive
from .place import Exact

Kind = Literal["reflex", "minimum", "node", "hole", "outside"]


@dataclass(eq=False)
class Node:
    """A leaf (`reflex`, with a wedge; `minimum`), an inner node or a root, all at a `level`.
    `groups` has places: a point, or all events of one flat ridge. The bar of leaf `elder` goes on
    above; `tie`: the least place alone decided so."""

    kind: Kind
    level: int
    groups: list[list[int]] = field(default_factory=list)
    wedge: int = -1
    children: list[Node] = field(default_factory=list)
    elder: Node | None = None
    tie: bool = False


@dataclass(frozen=True, eq=False)
class Bar:
    """A feature's life, (birth, death], of the leaf. Death may be infinity. `essential`: dies
    together with its component of the complement, or never."""

    leaf: Node
    birth: int
    death: int
    is_essential: bool


class Tree:
    """`roots`, `bars`, `nodes` (leaves, then inner nodes, rising)."""

    def __init__(self, levels: Levels) -> None:
        self.levels = levels
        graph = levels.graph
        self.nodes: list[Node] = []
        self.bars: list[Bar] = []
        self._sets = Sets(levels.ends - 1)
        self._of: dict[int, Node] = {}  # features now, by their sets' numbers
        for k in range(len(graph.outline.wedges)):
            leaf = Node("reflex", 0, wedge=k)
            leaf.elder = leaf
            self.nodes.append(leaf)
            self._of[len(graph.places) + k] = leaf
        self._falling: dict[int, list[int]] = {}
        for part in graph.parts:
            if not part.is_flat and part.high[0] == "place":
                self._falling.setdefault(part.high[1], []).append(levels.number(part.low))
        by_level: list[list[list[int]]] = [[] for _ in range(levels.infinity)]
        for group in levels.groups():
            by_level[levels.of_place[group[0]]].append(group)
        for level in range(1, levels.infinity):
            self._raise(level, by_level[level])
        self.roots = self._roots()

    def _raise(self, level: int, groups: list[list[int]]) -> None:
        """Unites features seen below by groups of places at a level."""
        find = self._sets.find
        seen = [
            {find(low) for place in group for low in self._falling.get(place, ())}
            for group in groups
        ]
        joint = Sets(len(groups))
        for a in range(len(groups)):
            for b in range(a):
                if seen[a] & seen[b]:
                    joint.join(a, b)
        born = []
        for members in joint.groups(range(len(groups))):
            below = set().union(*(seen[k] for k in members))
            if below:
                inner = [groups[k] for k in members if len(seen[k]) > 1]
                node = self._inner(level, inner, sorted(below)) if len(below) > 1 else (
                    self._of[next(iter(below))])  # fmt: skip
            else:
                node = Node("minimum", level, [groups[k] for k in members])
                node.elder = node
                self.nodes.append(node)
            born.append((node, [*below, *(place for k in members for place in groups[k])]))
        for node, ends in born:
            for end in ends:
                self._sets.join(ends[0], end)
            self._of[find(ends[0])] = node

    def _inner(self, level: int, groups: list[list[int]], below: list[int]) -> Node:
        features = {self._of[k]: k for k in below}
        node = Node("node", level, groups, children=list(features))
        self._choose(node, features)
        self.nodes.append(node)
        for child in features:
            self._end(child, node)
        return node

    def _end(self, child: Node, node: Node) -> None:
        leaf = child.elder
        assert leaf is not None
        if leaf is not node.elder:
            self.bars.append(Bar(leaf, leaf.level, node.level, False))

    def _choose(self, node: Node, features: dict[Node, int]) -> None:
        """The child whose bar goes on: the smallest birth, then the greatest depth, then the least
        place."""
        elders = {child: child.elder for child in features}
        least = min(leaf.level for leaf in elders.values() if leaf)
        rest = [child for child, leaf in elders.items() if leaf and leaf.level == least]
        if len(rest) > 1 and least == 0:
            depths = {child: self.depth_of(child, features[child], node.level) for child in rest}
            best = rest[0]
            for child in rest[1:]:
                if _order_of_depths(depths[child], depths[best]) > 0:
                    best = child
            rest = [c for c in rest if _order_of_depths(depths[c], depths[best]) == 0]
        node.tie = len(rest) > 1
        first = min(rest, key=cmp_to_key(self._place_order))
        node.elder = first.elder

    def depth_of(self, child: Node, feature: int, level: int) -> Number | None:
        """The least depth of a feature's elder leaf below its bridges at a level; None: no end."""
        leaf = child.elder
        assert leaf is not None
        at = self.levels.graph.outline.wedges[leaf.wedge].at
        best: Number | None = None
        for part in self.levels.graph.parts:
            low = self.levels.level(part.low)
            if low < level <= self.levels.level(part.high) and (
                self._sets.find(self.levels.number(part.low)) == feature
            ):
                own = depth(at, chord_at(self.levels, part, level))
                if best is None or order(own, best) < 0:
                    best = own
        return best

    def _place_order(self, a: Node, b: Node) -> int:
        """Compares places of elder leaves."""
        assert a.elder and b.elder
        if a.elder.kind == "reflex":
            return order_of_ends(self.levels, a.elder.wedge, b.elder.wedge)
        return order_of_places(self.least_place(a.elder), self.least_place(b.elder))

    def least_place(self, node: Node) -> Exact:
        """The least of all places of a node."""
        graph = self.levels.graph
        if node.kind == "reflex":
            x, y = graph.outline.wedges[node.wedge].at
            return number(x), number(y)
        points = [(graph.places[k].x, graph.places[k].y) for group in node.groups for k in group]
        return min(points, key=cmp_to_key(order_of_places))

    def _roots(self) -> list[Node]:
        """A root for each bounded component of the complement, and one for the outside."""
        levels = self.levels
        alive: dict[Node, int] = {}
        endless: set[int] = set()
        tops: dict[int, list[int]] = {}  # places that nothing leaves upwards
        rising = set()
        for part in levels.graph.parts:
            if part.high[0] == "infinity":
                endless.add(self._sets.find(levels.number(part.low)))
            if not part.is_flat and part.low[0] == "place":
                rising.add(part.low[1])
        for group in levels.groups():
            if not rising & set(group):
                tops.setdefault(self._sets.find(group[0]), []).append(group[0])
        group_of = {k: group for group in levels.groups() for k in group}
        found = []
        for end in range(levels.ends - 1):
            if self._sets.find(end) == end:
                alive[self._of[end]] = end
        outside = {node: end for node, end in alive.items() if end in endless}
        for node, end in alive.items():
            if end not in endless:
                greatest = max(levels.of_place[k] for k in tops[end])
                groups = [group_of[k] for k in tops[end] if levels.of_place[k] == greatest]
                root = Node("hole", greatest, groups, children=[node], elder=node.elder)
                assert node.elder is not None
                self.bars.append(Bar(node.elder, node.elder.level, greatest, True))
                found.append(root)
        if outside:
            root = Node("outside", levels.infinity, children=list(outside))
            self._choose(root, outside)
            for child in outside:
                self._end(child, root)
            assert root.elder is not None
            self.bars.append(Bar(root.elder, root.elder.level, levels.infinity, True))
            found.append(root)
        return found


def _order_of_depths(a: Number | None, b: Number | None) -> int:
    if a is None or b is None:
        return (a is None) - (b is None)
    return order(a, b)


def order_of_ends(levels: Levels, a: int, b: int) -> int:
    """Compares wedges: by vertex, then by the primitive direction of the edge that leaves it."""
    p, q = (levels.graph.outline.wedges[k] for k in (a, b))
    mine, other = ((w.at, primitive(w.second.along)) for w in (p, q))
    return (mine > other) - (mine < other)


def order_of_places(a: Exact, b: Exact) -> int:
    return order(a[0], b[0]) or order(a[1], b[1])
