"""Names without values: locations that a file does not teach, words of the language as names.

In: what is known of every name of a compilation. Out: warnings, one a cause.
"""
