"""Machines that fork where something from outside is looked at: every future, tick by tick.

In: an executable, a scene, and what is free. Out: machines that keep no past, what each has to be
told before it goes on, and what its state is. May not know which futures anybody looks at.
"""
