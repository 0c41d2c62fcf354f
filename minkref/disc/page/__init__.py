"""The page of `minkref view P disc`: the sum with a disc at any radius, in a browser."""
