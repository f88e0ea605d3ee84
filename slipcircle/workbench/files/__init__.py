"""Reading of scene files (TOML) and construction of scenes from them."""
