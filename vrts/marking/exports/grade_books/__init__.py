"""Grade books and worksheets of teachers, filled in and otherwise left as they are.

In: a teacher's table and the rows of a class. Out: the same table with marks.
Makes no table up.
"""
