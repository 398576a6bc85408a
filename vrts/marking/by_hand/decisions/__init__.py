"""What graders decide, as records: one file for each grader, to which is only ever added.

In: lines of `staff/decisions`. Out: what is decided about a class, and what contradicts itself.
Computes no mark.
"""
