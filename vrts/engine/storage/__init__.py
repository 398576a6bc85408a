"""Runs as the bytes of a `.vrun` file: a JSON manifest and numpy arrays in a zip, never pickle.

`save` makes the bytes; `load` reads them without trusting them, and re-makes the run from them, its
compiled sources and its scene, without executing anything; `compare` tells two runs apart.
"""
