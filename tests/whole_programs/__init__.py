"""Whole programs drawn by chance: every statement that is carried out, in scenes and scenarios.

In: a number. Out: a program with its scene and scenario, and what a trial of them has found.
"""
