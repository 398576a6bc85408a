"""Monitor and pendant at a real terminal. A door to prompt_toolkit.

In: keys and a clock. Out: what the terminal shows.
Knows no command.
"""
