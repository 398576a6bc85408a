"""The robot program and the process control program in execution: plain state.

In: programs in memory, arm, hand and memory. Out: the record that steps act on, and how programs
begin, are interrupted, go on and end.
Knows neither compiled steps nor ticks.
"""
