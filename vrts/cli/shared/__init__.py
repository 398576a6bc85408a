"""What commands have in common: options, console, progress, watching, windows.

In: what was typed and what is to be shown. Out: colour, text, exit statuses.
Knows no single command.
"""
