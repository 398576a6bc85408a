"""Tests of the tree of futures."""
