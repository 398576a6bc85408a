"""How somebody who has never met the others writes a program, from habits to the file."""
