"""Browser code: plain ES modules and style sheets, and the Python that puts them into one page.

In: names of modules. Out: their text, in the order in which they need each other.
Knows nothing of what a page is about.
"""
