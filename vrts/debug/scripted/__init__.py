"""The commands of the debugger as words: of keys, prompts, scripts and recorded sessions alike.

In: lines of a command file or of a key. Out: what each did, where it stands then, and why.
Knows no terminal.
"""
