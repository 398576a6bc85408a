"""A Run to verdicts, and verdicts to a mark. Opens no file and starts no process."""
