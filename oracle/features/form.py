"""The merge tree's canonical form (docs/features.md), from the judge's own tree."""

from __future__ import annotations

import json
from fractions import Fraction
from functools import cmp_to_key
from typing import Any

from .judge import Judge, Name
from .tree import Node, order_of_ends, order_of_places

ROOTS = ("hole", "outside")
KINDS = {"node": "merge"}


def canonical_nodes(judge: Judge) -> list[Node]:
    """Nodes by radius, roots last at each radius, then by the least place."""
    tree = judge.tree

    def before(a: Node, b: Node) -> int:
        sign = a.level - b.level or (a.kind in ROOTS) - (b.kind in ROOTS)
        if sign:
            return sign
        if a.kind == b.kind == "reflex":
            return order_of_ends(judge.levels, a.wedge, b.wedge)
        return order_of_places(tree.least_place(a), tree.least_place(b))

    return sorted([*tree.nodes, *tree.roots], key=cmp_to_key(before))


def canonical_json(judge: Judge) -> str:
    nodes = canonical_nodes(judge)
    number = {node: k for k, node in enumerate(nodes)}
    rank = {level: k for k, level in enumerate(sorted({node.level for node in nodes}))}
    places = _Events(judge)
    rows = [
        {
            "children": sorted(number[child] for child in node.children),
            "kind": KINDS.get(node.kind, node.kind),
            "level": rank[node.level],
            "places": places.of(node),
        }
        for node in nodes
    ]
    return json.dumps({"nodes": rows}, separators=(",", ":"))


class _Events:
    """Texts of places; places with the same features are numbered by radius, then by place."""

    def __init__(self, judge: Judge) -> None:
        self.judge = judge
        self.places = judge.graph.places
        order = sorted(range(len(self.places)), key=cmp_to_key(self._before))
        self.texts: dict[int, list[Any]] = {}
        seen: dict[tuple[Name, ...], int] = {}
        for k in order:
            features = tuple(sorted(judge.place_name(k), key=_key))
            self.texts[k] = [*map(list, features), seen.get(features, 0)]
            seen[features] = seen.get(features, 0) + 1

    def _before(self, a: int, b: int) -> int:
        levels = self.judge.levels.of_place
        return levels[a] - levels[b] or self._place_order(a, b)

    def _place_order(self, a: int, b: int) -> int:
        p, q = self.places[a], self.places[b]
        return order_of_places((p.x, p.y), (q.x, q.y))

    def of(self, node: Node) -> list[Any]:
        if node.kind == "reflex":
            return [list(self.judge.wedge_name(node.wedge))]
        by_place = cmp_to_key(self._place_order)
        groups = [sorted(group, key=by_place) for group in node.groups]
        groups.sort(key=lambda group: by_place(group[0]))
        return [[self.texts[k] for k in group] for group in groups]


def _key(name: Name) -> tuple[Any, ...]:
    return name[0] != "vertex", *map(Fraction, name[1:])
