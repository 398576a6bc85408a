"""What stands in the workspace, where a run starts from, and what may happen to it.

In: texts of scene, lab and scenario files. Out: a `Scene`, a `Scenario`, places, findings.
Knows no program and no run.
"""
