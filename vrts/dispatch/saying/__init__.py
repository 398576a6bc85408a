"""What every controller is told alike: signals by pins, names, calls, and what cannot be said.

In: IR and a file of the user. Out: answers about a program. Knows no language of any controller.
"""
