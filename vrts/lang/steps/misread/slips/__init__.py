"""Steps with a slip of the pen: a sign twice, letters for digits, digits before letters.

Takes the text of a step, gives what is meant by it. May not know other languages.
"""
