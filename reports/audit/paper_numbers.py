"""The paper's printed numbers: its tables, and the text's figures about them."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

SMALL = ("dog", "g1", "g2", "g3", "g4")
SOLIDS = ("ellipse", "GS3", "GS4", "TI", "v-rod")

# Rows: the scaled operand; columns: the other operand. Average speed-ups.
TABLE_1 = {
    "dog": ("28.911", "115.651", "5.592", "32.408", "6.538"),
    "g1": ("115.651", "131.150", "432.069", "533.141", "473.282"),
    "g2": ("15.223", "313.710", "298.038", "161.712", "88.916"),
    "g3": ("112.354", "152.790", "171.825", "34.347", "79.362"),
    "g4": ("14.519", "201.861", "45.220", "80.230", "122.565"),
}
TABLE_2 = {
    "ellipse": ("17.231", "16.653", "32.312", "14.636", "19.060"),
    "GS3": ("44.475", "18.311", "17.584", "17.423", "29.902"),
    "GS4": ("13.109", "17.273", "13.050", "18.026", "34.342"),
    "TI": ("18.685", "20.332", "19.669", "24.952", "37.960"),
    "v-rod": ("24.471", "40.246", "40.691", "44.757", "97.410"),
}
EDGES = {("monkey", "bird"): 16_425, ("neuron", "disc"): 3_196}
EVENTS = {("monkey", "bird"): 56_996_430, ("neuron", "disc"): 56_238}
FACETS = {"GS3": 320, "GS4": 500, "TI": 236}


def cells(
    table: Mapping[str, tuple[str, ...]], columns: tuple[str, ...]
) -> dict[tuple[str, str], Fraction]:
    """Table cells; each key is the scaled operand and the other operand."""
    return {
        (row, column): Fraction(value)
        for row, values in table.items()
        for column, value in zip(columns, values, strict=True)
    }
