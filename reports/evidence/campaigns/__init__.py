"""Campaigns: the same findings by any number of workers, whoever is killed; a ledger of 10^8 rows
answers in seconds."""
