"""The program verified again beside its scene: other places, speeds, and the dry run above.

In: a program and its scene. Out: how far the world may differ before something fails.
Knows neither bundle nor sheet.
"""
