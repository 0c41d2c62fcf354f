"""Scales with a factor for each axis: the one place where they are read and written, for the plane
(`SX,SY`) and for space (`SX,SY,SZ`)."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref.errors import Refusal
from minkref.exact import read_scale

PlaneScale = Fraction | tuple[Fraction, Fraction]
Scaling = tuple[str, str, str]
# By the number of axes: the required number of factors, and the error for any other.
COUNTS = {2: ("two", "scale-not-uniform"), 3: ("three", "scale-not-three")}


def read_plane_scale(text: str, option: str = "--scale") -> PlaneScale:
    """Read `S`, or `SX,SY`; equal factors are one number. Refuses what is not positive."""
    x, y = (Fraction(factor) for factor in read_factors(text, option, "xy"))
    return x if x == y else (x, y)


def read_scaling(text: str, option: str = "--scale") -> Scaling:
    """Read `S`, the same for all axes, or `SX,SY,SZ`, in lowest terms. Refuses factors that are not
    positive."""
    x, y, z = read_factors(text, option, "xyz")
    return (x, y, z)


def read_factors(text: str, option: str, axes: str) -> tuple[str, ...]:
    """Read a factor for each of the `axes`, in lowest terms: one number for all, or a list with
    commas. Refuses factors that are not positive."""
    parts = text.split(",")
    if len(parts) == 1:
        return (read_scale(text, option),) * len(axes)
    if len(parts) != len(axes):
        where = f"{option} {text[:40]}{'...' if len(text) > 40 else ''}"
        wanted, code = COUNTS[len(axes)]
        form = ",".join(f"S{axis.upper()}" for axis in axes)
        raise Refusal(
            f"these are {len(parts)} factors",
            where,
            f"give one positive number, or {wanted}: {form}",
            code,
        )
    return tuple(
        read_scale(part, f"{option} {axis}") for part, axis in zip(parts, axes, strict=True)
    )


def joined(factors: Sequence[str]) -> str:
    """Write the factors as they are read: `S` if all are equal, else `SX,SY` or `SX,SY,SZ`."""
    return factors[0] if len(set(factors)) == 1 else ",".join(factors)
