"""Exception for failed checks."""


class ProofError(Exception):
    """Failed check of a claim: the claim, the value found, the value required, and the name of the check."""

    def __init__(self, claim: str, found: object, wanted: object = 0, check: str = "") -> None:
        # All four, so that it can be pickled.
        super().__init__(claim, str(found), str(wanted), check)
        self.check = check

    def __str__(self) -> str:
        """Return the claim with the value found and the value required."""
        claim, found, wanted, _ = self.args
        return f"{claim}: found {found}, wanted {wanted}"
