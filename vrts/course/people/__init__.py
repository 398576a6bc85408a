"""Who is who in a course: lists of the class and of staff, and accounts that follow them.

In: `course.toml`, a list of the class, what teachers add in the page. Out: accounts with their
rights, and links for those who come in for the first time.
"""
