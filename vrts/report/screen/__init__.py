"""Text for terminals: diagnostics with their lines, the first screen, places, states.

In: what was found. Out: text, with colour as a layer over it.
Prints nothing.
"""
