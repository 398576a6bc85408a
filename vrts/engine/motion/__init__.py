"""Motion: from locations and settings to polynomials of the six joints in path time."""
