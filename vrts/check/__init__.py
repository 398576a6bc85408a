"""A run to verdicts, and verdicts to a mark.

In: a run, its scene, a task. Out: a `Judgement` and a `Grade`, with the evidence behind them.
Opens no file, starts no process, and writes nothing that people read but headlines.
"""
