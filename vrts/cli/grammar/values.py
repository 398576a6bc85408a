"""What may stand for a parameter, by its name: for completion, and for a word in `--help`."""

import click


def completed(param: click.Parameter) -> click.Parameter:
    """Return a parameter whose values a shell can complete."""
    return param
