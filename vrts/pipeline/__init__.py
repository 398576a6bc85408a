"""The stages for one request, composed, and the files they need.

In: a request: program, reading, setting, what is wanted. Out: what each stage found.
Writes nothing, and decides nothing that a stage decides.
"""
