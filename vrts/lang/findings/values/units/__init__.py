"""Numbers that look as if they had another unit: radians, milliseconds, metres, inches.

In: what a program asks of angles, times, lengths and speeds, and its data sections. Out: warnings.
Speaks of a number only where no sensible program would write it in the unit of the language.
"""
