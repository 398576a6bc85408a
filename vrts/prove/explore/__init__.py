"""The search: futures one after another, merged where their states are alike, until none is left.

In: programs, scene, environment. Out: the futures that go wrong, by their decisions, and what was
covered. May not know how motion is certified, nor what anything is called in words.
"""
