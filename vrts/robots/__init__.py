"""Arms and grippers as data, their kinematics and arm branches: the only door to pinocchio.

In: names, URDF, poses, configurations. Out: robots with the source of every number; solutions.
Knows no scene and no program.
"""
