"""Help for the editor in the page: a language server for each, in a process without rights.

In: what a browser asks about one text. Out: what the language server answers, names and positions
and words alone. Knows neither rooms nor programs that are kept.
"""
