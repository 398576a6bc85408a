"""`vrts course`: a term on the live server, begun, checked and told from the command line.

In: the folder of a course and that of its server. Out: files to begin with, faults, who is who,
and personal links.
"""
