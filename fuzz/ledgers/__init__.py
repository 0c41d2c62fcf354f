"""A campaign's ledger: Parquet parts, one for each chunk of cases, compacted and asked by SQL."""
