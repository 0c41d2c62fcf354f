"""`minkref verify` judges sets grown by a disc: no false alarm, all seeded faults are found, and
each wrong result of a library is confirmed by distances in plain fractions."""
