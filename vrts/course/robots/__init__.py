"""Robots of a course: one of their own for each student or team, and time slots for the shared one.

In: a course, its people, what they ask for. Out: rooms, and who has a shared robot when.
"""
