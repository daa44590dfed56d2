"""What is wrong with an input, as exceptions."""

from typing import NamedTuple


class Problem(NamedTuple):
    """One thing that is wrong with an input, or was guessed or left out."""

    where: str  #: "file:line: key", as far as it is known
    what: str  #: one sentence, with what would be right

    def __str__(self) -> str:
        return f"{self.where}: {self.what}" if self.where else self.what


class InputError(ValueError):
    """An input was refused. Its text names every problem, one a line, in the words of the program."""

    def __init__(self, problems: list[Problem]) -> None:
        self.problems = list(problems)  #: at least one
        super().__init__("\n".join(map(str, self.problems)))

    def __reduce__(self) -> tuple[type, tuple[list[Problem]]]:
        return InputError, (self.problems,)
