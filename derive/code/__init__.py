"""From expressions to programs; what a program gives as every machine rounds it; and the text of programs."""
