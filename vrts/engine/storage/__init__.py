"""Runs as the bytes of a `.vrun` file: a JSON manifest and numpy arrays in a zip.

In: a run, or bytes that nobody vouches for. Out: bytes, or a run, or a diagnostic.
Nothing is pickled, and no file is opened here.
"""
