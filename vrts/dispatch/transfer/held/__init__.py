"""What a controller holds: asked for, read, and compared with a bundle.

In: a conversation. Out: programs, locations and values, and where they differ.
Changes nothing in a controller.
"""
