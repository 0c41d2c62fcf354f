"""The checker that is proved right in Coq agrees with the others, refuses mutants, takes bearable
time, and makes a theorem of a sum with a hole; its programs for points and sums without a
certificate answer like the reference, and refuse the operands that the reference refuses."""
