"""Commands about one program in motion: `run`, `verify`, `view`, `monitor`, `debug`.

In: a program and a setting. Out: what it does, at a terminal, as a page, or as a recording.
Knows no class and no server.
"""
