"""Compiler, simulator and verifier for VAL-II robot programs."""

__version__ = "0.1.0"
