"""What `import vrts` offers: a dozen names over the whole of vrts.

In: programs as files or text, scenes and tasks by name. Out: values with units in their names.
The commands of the same names stand on the same functions. What cannot be done is a `VrtsError`.
"""
