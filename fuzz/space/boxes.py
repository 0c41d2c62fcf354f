"""Boxes along the axes, and a box tree."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from minkref.fuzz.geometry.space import Whole

Box = tuple[int, int, int, int, int, int]  # lowest and highest x, y, z
LEAF = 8  # boxes in a leaf


def box_of(points: Iterable[Whole]) -> Box:
    xs, ys, zs = zip(*points, strict=True)
    return (min(xs), max(xs), min(ys), max(ys), min(zs), max(zs))


def boxes_meet(a: Box, b: Box) -> bool:
    return (
        a[0] <= b[1]
        and b[0] <= a[1]
        and a[2] <= b[3]
        and b[2] <= a[3]
        and a[4] <= b[5]
        and b[4] <= a[5]
    )


def box_pairs(first: list[Box], second: list[Box], reach: int) -> Iterator[tuple[int, int]]:
    """Yields pairs of boxes that meet after the boxes in `first` grow by `reach` on all sides."""
    if not first or not second:
        return
    rows = list(zip(*second, strict=True))
    low = [min(rows[k]) - reach for k in (0, 2, 4)]
    high = [max(rows[k]) + reach for k in (1, 3, 5)]
    order = sorted(range(len(second)), key=lambda j: second[j][0])
    entries = [(*second[j], j) for j in order]
    for i, (left, right, front, back, bottom, top) in enumerate(first):
        if (
            left > high[0]
            or right < low[0]
            or front > high[1]
            or back < low[1]
            or bottom > high[2]
            or top < low[2]
        ):
            continue
        left, right = left - reach, right + reach
        front, back = front - reach, back + reach
        bottom, top = bottom - reach, top + reach
        for x0, x1, y0, y1, z0, z1, j in entries:
            if x0 > right:
                break
            if x1 >= left and y0 <= back and y1 >= front and z0 <= top and z1 >= bottom:
                yield i, j


class BoxTree:
    """`meeting` returns the numbers of boxes that meet a box, in order."""

    def __init__(self, boxes: Sequence[Box]) -> None:
        self._boxes = boxes
        self._root = self._node(list(range(len(boxes)))) if boxes else None

    def _node(self, numbers: list[int]) -> _Node:
        columns = list(zip(*(self._boxes[k] for k in numbers), strict=True))
        x0, x1, y0, y1, z0, z1 = (
            max(column) if k % 2 else min(column) for k, column in enumerate(columns)
        )
        node = _Node((x0, x1, y0, y1, z0, z1), numbers)
        if len(numbers) > LEAF:
            lengths = [x1 - x0, y1 - y0, z1 - z0]
            axis = 2 * lengths.index(max(lengths))
            numbers.sort(key=lambda k: self._boxes[k][axis] + self._boxes[k][axis + 1])
            half = len(numbers) // 2
            node.children = (self._node(numbers[:half]), self._node(numbers[half:]))
        return node

    def meeting(self, box: Box) -> list[int]:
        found: list[int] = []
        waiting = [self._root] if self._root else []
        while waiting:
            node = waiting.pop()
            if not boxes_meet(node.box, box):
                continue
            if node.children:
                waiting += node.children
            else:
                found += [k for k in node.numbers if boxes_meet(self._boxes[k], box)]
        return sorted(found)


class _Node:
    def __init__(self, box: Box, numbers: list[int]) -> None:
        self.box = box
        self.numbers = numbers
        self.children: tuple[_Node, ...] = ()
