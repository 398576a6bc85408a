"""What goes into an autograder for Gradescope as it stands: shell scripts and words."""
