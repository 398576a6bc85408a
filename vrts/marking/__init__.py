"""A class of submissions: which files to mark, each to a result row, whatever it contains."""
