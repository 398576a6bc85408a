"""The debugger on a whole terminal screen: keys in, rows of text out.

In: keys, and a debugging session. Out: what the screen shows. A door to prompt_toolkit.
Knows no protocol of editors.
"""
