"""Kinds of mistakes: each takes a program and a source of chance, and gives the program with one.

In: programs as steps and rows. Out: the text of the program with a mistake, or None where there is
no place for it. Whether a mistake costs a point is not asked here.
"""
