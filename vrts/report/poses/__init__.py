"""Where bodies and the hand are at many instants at once, as arrays.

In: a run and times. Out: joints, rotations, origins, quaternions. Knows no format that they are
written in.
"""
