"""A folder for LinuxCNC carried out by an installed LinuxCNC, and compared with its run.

In: the files of a folder, and its run. Out: what was recorded, compared motion by motion.
Starts processes of its own namespaces in a folder of its own; knows nothing of programs.
"""
