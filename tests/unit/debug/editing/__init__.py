"""Tests of texts changed while they are debugged."""
