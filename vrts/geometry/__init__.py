"""Convex shapes and the questions asked about them: the only door to coal and fcl.

In: shapes and poses. Out: distances, supports, boxes, meshes.
Knows no robot and no scene.
"""
