"""Takes decisions from the page: sound, about what was shown, all of them or none.

In: JSON, which is not trusted. Out: records at the end of a grader's file.
Knows nothing of HTTP.
"""
