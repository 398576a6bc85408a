"""Forward and inverse kinematics of any arm, one pose at a time or many at once.

In: an arm, poses in B, configurations [rad]. Out: frames, solutions on each arm branch.
Knows no robot by name.
"""
