"""A verified program on its way to a real controller: plan, bundle, transfer, other dialects.

In: programs in their setting, a profile of a controller. Out: bundles, sheets, transcripts.
Never executes a program on a robot, enables power or calibrates.
"""
