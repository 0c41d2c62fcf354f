"""The command for scenes."""
