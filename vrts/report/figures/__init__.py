"""Measured curves and paths as SVG in pages.

In: arrays of times and values. Out: markup. Knows neither runs nor logs.
"""
