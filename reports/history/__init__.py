"""Pages of a campaign's ledger: libraries over their versions."""
