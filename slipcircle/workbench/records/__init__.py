"""Records of ground motion and of pore pressure, read from files."""
