"""The audit of the paper passes all its checks in time, and every figure of its pages is drawn by a
browser."""
