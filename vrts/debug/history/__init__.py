"""Who wrote a value last, when it changes next, and why it is so: as instants to jump to.

In: a run, an instant, a name. Out: changes with their steps. Knows no client and changes nothing.
"""
