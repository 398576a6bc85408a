"""Why something went wrong: chains of causes backward through a run, to the step that is to blame.

In: a run, what it is judged by. Out: chains of at most five links, each with time, line and words.
Executes nothing: what a step read is looked up in histories. Knows no report.
"""
