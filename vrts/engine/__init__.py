"""IR, scene and scenario to a run.

In: a compiled module, a scene, a scenario, timed commands. Out: a `Run` that answers for any time.
Sees no source text, opens no file and reads no clock.
"""
