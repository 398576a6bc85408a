"""The hand: strokes of the fingers, what they grasp and carry, where it comes to rest.

In: commands of the hand, bodies and their places. Out: strokes, attachments, places of bodies.
Knows no program.
"""
