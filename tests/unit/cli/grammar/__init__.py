"""Tests of how commands are spoken."""
