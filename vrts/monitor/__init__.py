"""The monitor: the operator's dialogue over a controller."""
