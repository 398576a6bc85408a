"""Motion: from locations and settings to polynomials of the six joints in path time.

In: requests of motions, an arm. Out: segments, remarks, or why it cannot be done.
Knows no program, no hand and no bodies.
"""
