"""The paper's claims and the hard cases, judged."""
