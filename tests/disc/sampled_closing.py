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
    # Some disc covers the whole cell; no disc meets the cell.
    covered = step * cells_to(centres)[box] < radius - half
    missed = step * cells_to(nearby)[box] >= radius + 2 * half
    outside = distance[box] >= half
    return float((missed & outside).sum()) * step**2, float((~covered).sum()) * step**2


def cells_to(chosen: np.ndarray) -> np.ndarray:
    """Each grid point's distance from the nearest chosen one, in cells: axis by axis."""
    far = 4.0 * chosen.size
    away = [np.abs(np.subtract.outer(np.arange(n), np.arange(n))) for n in chosen.shape]
    along = np.where(chosen[None, :, :], away[0][:, :, None], far).min(axis=1)
    square = np.array([(away[1] ** 2 + row[None, :] ** 2).min(axis=1) for row in along])
    return np.sqrt(square)
