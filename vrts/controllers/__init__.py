"""Models of controllers as data: how is read what the documents leave open about time and motion.

In: nothing. Out: a `ControllerModel` by its name, each reading with unit, status and source.
Knows no arm and no program: the engine reads a model, and nothing here carries one out.
"""
