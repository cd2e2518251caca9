"""Files that come with the package, by name."""

from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

from exactmesh.errors import InputError


@dataclass(frozen=True, slots=True)
class Shelf:
    """The files with one suffix in a folder of the package; `what` names one of them in messages."""

    package: str
    suffix: str
    what: str

    def names(self) -> tuple[str, ...]:
        """Return the names of the files without the suffix, sorted."""
        return tuple(sorted(entry.name.removesuffix(self.suffix) for entry in files(self.package).iterdir()
                            if entry.name.endswith(self.suffix)))

    def path(self, name: str) -> Path:
        """Return the path of a file; raises `InputError`, listing the names, when there is none of that name."""
        if name not in self.names():
            raise InputError(f"there is no {self.what} {name!r}; there are: {', '.join(self.names())}")
        return Path(str(files(self.package).joinpath(name + self.suffix)))
