"""What goes into an autograder for Gradescope as it stands: shell scripts and words.

In: nothing. Out: files that `autograder_zip` packs.
Is never imported.
"""
