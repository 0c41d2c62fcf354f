"""Boundary and topology events are where the sum changes and nowhere else: a sampling judge, the
solid that the sum sweeps, static sums around each event, and tight passages made by hand."""
