"""Vertices and holes of the shipped models, as their names and papers have them."""

from __future__ import annotations

SHIPPED = {
    "glyph1204": (1204, 0),
    "glyph275": (275, 0),
    "cells1815": (1815, 18),
    "g1": (30, 0),
    "g2": (34, 0),
    "g3": (24, 0),
    "g4": (43, 0),
    "dog145": (145, 0),
    "beetle": (156, 0),
    "disc1": (32, 0),
    "disc5": (32, 0),
}
