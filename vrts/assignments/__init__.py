"""Assignments: written from templates, checked, copied, and packed for students and staff.

In: folders of tasks, scenes and their staff parts. Out: texts of new files, findings, zips.
Knows no class: who handed in what is the business of `marking`.
"""
