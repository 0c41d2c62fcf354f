"""`minkref verify` raises no false alarm: each wrong result is confirmed by the slow engine,
adapters with every habit that the protocol allows pass, and of other libraries it finds the known
faults."""
