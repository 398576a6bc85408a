"""Expressions of the language as closures: operators, functions, variables, strings.

In: expressions of the IR. Out: closures that give values in single precision.
Knows no instruction.
"""
