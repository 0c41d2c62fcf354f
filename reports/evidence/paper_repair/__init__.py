"""The paper's repair of convex sums (Section 6), followed sentence by sentence: in its right form
it is the proven update; how often each sentence as printed loses the sum."""
