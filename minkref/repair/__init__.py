"""Repair of files: every change listed, exact, nothing else changed (docs/repair.md)."""
