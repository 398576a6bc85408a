"""What the page shows of a class and of each row: the work list, its order, causes, likeness.

In: the state of the folder. Out: values that become JSON.
Reads no files.
"""
