"""From expressions to programs, and from programs to the text of `generated`."""
