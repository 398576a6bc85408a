"""What is proven of the distance of two convex shapes, by the shapes alone.

In: placed shapes, and proposals nobody vouches for. Out: bounds below and above, with their proof:
a direction along which the shapes are apart, and points inside them. Calls no distance library.
"""
