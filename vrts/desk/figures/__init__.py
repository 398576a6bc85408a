"""Statistics of a class: histograms, how well checks tell good from poor, graders compared.

In: the state of the folder. Out: numbers.
Reads no files.
"""
