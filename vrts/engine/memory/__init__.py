"""The controller's memory and everything that happened, so that any moment can be had again.

In: values, events and statements as they come. Out: the same for any earlier moment.
Knows neither programs nor ticks.
"""
