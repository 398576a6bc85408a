"""Convex shapes and the questions asked about them: the only door to coal and fcl."""
