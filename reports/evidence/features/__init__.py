"""Features of a growing disc are those of judges of their own; regions tile what a hull adds, cuts
resolve their notches, certificates hold, readings of many radii are fast, and `verify` accuses
nobody wrongly."""
