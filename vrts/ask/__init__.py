"""What somebody asks in words, answered with pages of the manual.

In: a question, and the package's own pages, words and commands. Out: pages in order, and text for a
terminal. Knows no files of users.
"""
