"""Judges of how large a disc may be, and of distances of moving parts, by all pairs."""

from .moving import squared_distance_on_path
from .rooms import Rooms
from .segments import is_inside, path_distance

__all__ = ["Rooms", "is_inside", "path_distance", "squared_distance_on_path"]
