"""A course: a term on the live server, with who is who, a robot for each, assignments, a board.

In: a folder with `course.toml`, what people do in its rooms. Out: hand-ins as marking takes them,
what teachers and students see of them. Adds pages to the live server, and computes no mark.
"""
