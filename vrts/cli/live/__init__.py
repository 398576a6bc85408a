"""Commands about shared sessions: `serve`, `teach`, `replay`.

In: scenes, addresses, logs. Out: a server that runs, a run repeated.
Needs the extra `live`.
"""
