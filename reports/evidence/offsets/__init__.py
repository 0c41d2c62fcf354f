"""`minkref verify` judges sets and lines grown by a disc, with all joins, and sets eroded: no false
alarm, all seeded faults are found, and each wrong result of a library is confirmed by distances in
plain fractions."""
