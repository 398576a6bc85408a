"""Robots from URDF descriptions, which nobody vouches for.

In: the text of a description and its meshes. Out: a robot, or what is wrong with it.
Opens no file, but for the arms of Universal Robots in their wheel.
"""
