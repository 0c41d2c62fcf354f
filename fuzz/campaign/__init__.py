"""Campaigns: runs on many workers and machines, which continue after any death."""
