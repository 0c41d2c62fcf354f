"""Certificates for sums: proofs that a checker follows without trusting us."""
