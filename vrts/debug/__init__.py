"""Debugging: breakpoints, steps and alarms as questions to a run, forward and backward."""
