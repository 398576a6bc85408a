"""Certificates of collision checks, and the small checker that believes nothing but them.

In: a scene, a run, and what was found in it; or bytes that nobody vouches for. Out: a certificate,
or what one proves. The checker knows no distance library and nothing of the search.
"""
