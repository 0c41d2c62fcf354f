"""Runs that are killed, interrupted or resumed from changed ledgers lose nothing that was reported,
believe nothing that was changed, and leave nothing behind."""
