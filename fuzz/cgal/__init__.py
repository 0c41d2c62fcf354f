"""Client of the CGAL oracle, and the stand-alone program for a fault."""
