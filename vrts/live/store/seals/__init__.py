"""Signs of the logs, made with a key that the database does not hold: what was cut or lost shows.

In: what is appended, named and purged. Out: signed heads, a signed list of rooms, signed notes of
what was purged, and what does not fit them. Nothing is signed over what does not fit.
"""
