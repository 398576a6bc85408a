"""Tests of fairness: variants that can be done, that are as hard as each other, and copies."""
