"""The language server: what an editor shows of programs while they are written.

In: texts that change. Out: names, hints, findings, edits.
Knows no protocol: that is in `server`.
"""
