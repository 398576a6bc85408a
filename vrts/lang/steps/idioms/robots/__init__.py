"""What other robot languages write, one file a maker.

In: nothing. Out: tables of idioms, whose words the relatives of VAL-II share in part.
"""
