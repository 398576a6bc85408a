"""The command line: click commands, one file each, in a folder for each group.

In: words of a command line. Out: text, files, an exit status.
Decides nothing: every answer comes from the packages below. The only door to click.
"""
