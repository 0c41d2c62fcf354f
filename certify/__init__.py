"""Certificates of sums: proofs that a checker follows without trusting us."""
