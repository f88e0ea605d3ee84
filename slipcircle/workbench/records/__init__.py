"""Records of shaking and of water, read from files."""
