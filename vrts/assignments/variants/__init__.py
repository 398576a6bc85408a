"""A task in its variants: the key, the files and the setting of each, and what students get.

In: the folder or zip of a task with `[variants]`, a key, who the students are. Out: an ordinary
task for each variant, zips, and the table for staff. `of_task.load_varied` is where to begin.
Knows students by an identifier alone: lists of a class are the business of `marking`.
"""
