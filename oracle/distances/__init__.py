"""A judge of moving discs and distances between moving parts, by all pairs."""

from .moving import squared_distance_inside, squared_distance_on_path
from .part_rooms import PartRooms
from .rooms import Rooms
from .segments import is_inside, path_distance

__all__ = [
    "PartRooms",
    "Rooms",
    "is_inside",
    "path_distance",
    "squared_distance_inside",
    "squared_distance_on_path",
]
