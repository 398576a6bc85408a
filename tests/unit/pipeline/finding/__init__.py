"""Tests of finding the task of a program."""
