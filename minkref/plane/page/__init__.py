"""The page of `minkref view`: the sum over a window of scales, to be looked at in a browser."""
