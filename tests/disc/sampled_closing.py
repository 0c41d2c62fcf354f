"""A closing with a disc, sampled on a grid in doubles: bounds for the area that it adds."""

from __future__ import annotations

import numpy as np

from minkref.fuzz.geometry.plane import Shape


def distances(shape: Shape, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Each point's distance from the boundary, and whether the point lies inside."""
    square = np.full(x.shape, np.inf)
    inside = np.zeros(x.shape, dtype=bool)
    for polygon in shape:
        for ring in polygon:
            for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]], strict=True):
                ax, ay, bx, by = map(float, (ax, ay, bx, by))
                dx, dy = bx - ax, by - ay
                part = np.clip(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0, 1)
                square = np.minimum(square, (x - ax - part * dx) ** 2 + (y - ay - part * dy) ** 2)
                if dy != 0:
                    crosses = (ay > y) != (by > y)
                    inside ^= crosses & (x < ax + (y - ay) / dy * dx)
    return np.sqrt(square), inside


def added_area(shape: Shape, radius: float, cells: int) -> tuple[float, float]:
    """Bounds for the area of closing(P) minus P. A cell belongs to neither sum, to the upper one
    only, or to both: the bounds allow for half a diagonal of a cell wherever a cell's centre stands
    for the cell, or a sampled disc for all discs nearby."""
    points = np.array([[float(c) for c in p] for polygon in shape for r in polygon for p in r])
    low, high = points.min(axis=0) - 2.5 * radius, points.max(axis=0) + 2.5 * radius
    step = float((high - low).max()) / cells
    half = step / 2**0.5 + 1e-9
    x, y = np.meshgrid(
        np.arange(low[0], high[0] + step, step), np.arange(low[1], high[1] + step, step)
    )
    distance, inside = distances(shape, x, y)
    distance = np.where(inside, -distance, distance)
    centres = distance >= radius
    nearby = distance >= radius - half
    box = (
        (x >= points[:, 0].min() - step)
        & (x <= points[:, 0].max() + step)
        & (y >= points[:, 1].min() - step)
        & (y <= points[:, 1].max() + step)
        & (distance > -half)
    )
    asked = np.stack([x[box], y[box]], axis=1)
    # Some disc covers the whole cell; no disc meets the cell.
    covered = _nearest(asked, x, y, centres) < radius - half
    missed = _nearest(asked, x, y, nearby) >= radius + 2 * half
    outside = distance[box] >= half
    return float((missed & outside).sum()) * step**2, float((~covered).sum()) * step**2


def _nearest(asked: np.ndarray, x: np.ndarray, y: np.ndarray, chosen: np.ndarray) -> np.ndarray:
    """The distance of each point from the nearest chosen grid point."""
    core = chosen.copy()
    core[1:-1, 1:-1] &= ~(
        chosen[:-2, 1:-1] & chosen[2:, 1:-1] & chosen[1:-1, :-2] & chosen[1:-1, 2:]
    )
    border = np.stack([x[core], y[core]], axis=1)
    found = np.full(len(asked), np.inf)
    for first in range(0, len(asked), 2000):
        part = asked[first : first + 2000]
        away = ((part[:, None, :] - border[None, :, :]) ** 2).sum(axis=2)
        found[first : first + 2000] = np.sqrt(away.min(axis=1))
    inside = {(round(float(a), 9), round(float(b), 9)) for a, b in zip(x[chosen], y[chosen],
                                                                       strict=True)}  # fmt: skip
    own = [(round(float(a), 9), round(float(b), 9)) in inside for a, b in asked]
    return np.where(own, 0.0, found)
