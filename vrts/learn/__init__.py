"""Lessons: folders of an example divided into steps, copied, and checked by what is in them.

In: `lesson.toml`, and the files of whoever learns. Out: which steps are done, what comes next, why.
Programs of learners are compiled and executed as `verify` does it, and in no other way.
"""
