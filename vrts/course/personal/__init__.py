"""What a course keeps of a person beside the server's database: handed out whole, and forgotten.

In: the folders of course and server, and a name. Out: a zip; or nothing of theirs any more.
"""
