"""What is typed at a controller: monitor commands, single steps, programs to LOAD.

In: lines of text. Out: commands and steps, or diagnostics.
Executes nothing.
"""
