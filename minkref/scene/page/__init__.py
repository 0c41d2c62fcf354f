"""The page of a scene: copies to drag and to scale, and the free space that is left."""
