"""Variants in a class: who has which by the list of the class, handed out, and marked by it.

In: the list of a class as a platform exports it, a task with variants, the teacher's key. Out: zips
and a table; a marker that marks each by the own variant; who seems to have another one's.
"""
