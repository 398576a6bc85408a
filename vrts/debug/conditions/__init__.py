"""Expressions at many instants of a run: compiled once, worked out from histories.

In: a text, instants. Out: values, by the engine's own closures over what histories say.
Knows no protocol; what histories do not say is asked of the controller, on a fork.
"""
