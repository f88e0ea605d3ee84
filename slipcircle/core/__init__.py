"""The core: what a scene is (`scene`), how it is integrated (`flow`), and what became of it (`motion`)."""
