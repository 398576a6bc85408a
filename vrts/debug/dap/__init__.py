"""The debug adapter protocol over standard input and output: a thin shell over the debugger."""
