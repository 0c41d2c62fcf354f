"""Drawings as operands: DXF and SVG, with the decimals of their text (docs/formats.md)."""
