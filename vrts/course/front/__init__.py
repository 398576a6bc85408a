"""Pages of a course over HTTP: who may ask, what is answered; the door to the web framework.

In: requests of browsers that are logged in. Out: JSON and files. What is true of the course is
known elsewhere.
"""
