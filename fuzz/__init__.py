"""Differential testing: generators, targets, comparison with exact witnesses, runner."""
