"""Scenes, placed and scaled copies of shapes around a robot: values and files."""
