"""The side of the pipeline that needs no robot: programs compiled, laid out, and stored.

In: bytes of programs, and how they are to be read. Out: what was compiled, and what was found.
May not know scenes, runs, checks, or any heavy library.
"""
