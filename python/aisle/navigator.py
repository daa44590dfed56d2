"""What a driving method is."""

from typing import Protocol

from ._aisle import Command, Decision, Observation


class Navigator(Protocol):
    """A driving method: any object with this method; it need not inherit from this class.

    Its only clock should be Observation.stamp_s, so that the same observations give the same decisions.
    """

    def step(self, observation: Observation) -> Command | Decision:
        """Decides on one observation. A Command drives on; a Decision may also end the mission."""
        ...
