"""Everything around the core: files and records, stability, studies, outputs, the price list, the command line."""
