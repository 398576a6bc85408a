"""The contract between language and engine: programs with no language question left open.

In: what `lang` lowers. Out: what `engine` executes, and a stable text of it.
Knows no spelling and no robot.
"""
