"""What a real robot did, beside what was simulated.

In: a run, and logs or frames of a real robot. Out: offsets, errors, timing, a fitted lab.
Changes no verdict: it says how far a simulation can be believed.
"""
