"""Log-in by a provider of OpenID Connect: the only connection that the server ever begins.

In: what a course says of its provider, and what browsers bring back from there. Out: who somebody
is for the provider. Without a provider nothing here is even loaded.
"""
