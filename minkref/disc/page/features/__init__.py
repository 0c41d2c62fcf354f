"""The page of `minkref view P --features`: concave features at any diameter, in a browser."""
