"""A page of results that needs no other file and no network: texts, pictures, commands, versions and hashes."""

import base64
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from html import escape

_STYLE = """
:root { color-scheme: light dark; --ink: #14202e; --ground: #fff; --soft: #5c6673; --line: #d5dbe3; --block: #f4f6f9;
  --good: #00664a; --bad: #a62b00 }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e9f0; --ground: #12171f; --soft: #9aa7b8; --line: #323c4a;
  --block: #1b222c; --good: #4fd1a5; --bad: #ff8a5c } }
body { font: 16px/1.5 sans-serif; color: var(--ink); background: var(--ground); margin: 0 auto; max-width: 76rem;
  padding: 1.5rem }
h1 { font-size: 1.7rem } h2 { margin-top: 3rem; border-top: 1px solid var(--line); padding-top: 1rem }
h3 { margin-top: 2.2rem } a { color: inherit } nav ul { columns: 20rem; padding-left: 1.2rem }
pre { background: var(--block); padding: .8rem; overflow-x: auto; font-size: .8rem; line-height: 1.35 }
code { background: var(--block); padding: .1rem .3rem; overflow-wrap: anywhere }
figure { margin: 1rem 0; background: #fff; padding: .5rem; border: 1px solid var(--line); overflow-x: auto }
figure svg, figure img { display: block; width: 100%; height: auto }
table { border-collapse: collapse; font-size: .85rem } td, th { padding: .15rem .8rem .15rem 0; text-align: left;
  vertical-align: top } td.hash { font-family: monospace; overflow-wrap: anywhere }
.command::before { content: "$ "; color: var(--soft) } .good { color: var(--good) } .bad { color: var(--bad) }
details { margin: .6rem 0 } summary { cursor: pointer; color: var(--soft) }
"""


@dataclass(frozen=True, slots=True)
class Picture:
    """An SVG; one that `is_plain` has no style sheet of its own and stands in the page as it is."""

    svg: str
    name: str
    is_plain: bool = True


@dataclass(frozen=True, slots=True)
class Section:
    """One result. `commands` make it, the first one all of it; `inputs` are names with SHA-256 hashes.

    `holds` is None where nothing is judged; `about` is a sentence for readers. A part stands under the section before
    it.
    """

    anchor: str
    title: str
    commands: tuple[str, ...]
    text: str = ""
    pictures: tuple[Picture, ...] = ()
    inputs: Mapping[str, str] = field(default_factory=dict)
    holds: bool | None = None
    about: str = ""
    is_part: bool = False

    def record(self) -> dict[str, object]:
        """Return the section without its pictures, for programs."""
        return {"id": self.anchor, "title": self.title, "commands": list(self.commands), "text": self.text,
                "pictures": [picture.name for picture in self.pictures], "inputs": dict(self.inputs),
                "holds": self.holds}


def page(title: str, lead: str, versions: Mapping[str, str], sections: Sequence[Section]) -> str:
    """Return the page."""
    links = "".join(f'<li><a href="#{section.anchor}">{escape(section.title)}</a></li>'
                    for section in sections if not section.is_part)
    rows = "".join(f"<tr><th>{escape(name)}</th><td>{escape(version)}</td></tr>" for name, version in versions.items())
    parts = ["<!doctype html>", '<html lang="en"><head><meta charset="utf-8">',
             '<meta name="viewport" content="width=device-width">', f"<title>{escape(title)}</title>",
             f"<style>{_STYLE}</style></head><body>", f"<h1>{escape(title)}</h1>", f"<p>{escape(lead)}</p>",
             f'<table class="versions">{rows}</table>', f"<nav><ul>{links}</ul></nav>", "<main>"]
    parts += [_section(section) for section in sections]
    return "\n".join([*parts, "</main></body></html>", ""])


def _section(section: Section) -> str:
    level = "h3" if section.is_part else "h2"
    parts = [f'<section id="{section.anchor}">', f"<{level}>{escape(section.title)}</{level}>"]
    if section.about:
        parts.append(f"<p>{escape(section.about)}</p>")
    if section.holds is not None:
        word, look = ("all that is checked here holds", "good") if section.holds else ("a check FAILS", "bad")
        parts.append(f'<p class="{look}">{word}</p>')
    parts += [_figure(picture) for picture in section.pictures]
    if section.text:
        parts.append(f"<pre>{escape(section.text)}</pre>")
    first, *others = section.commands
    parts.append(f'<p><code class="command">{escape(first)}</code></p>')
    if others:
        items = "".join(f'<li><code class="command">{escape(command)}</code></li>' for command in others)
        parts.append(f"<details><summary>its parts alone ({len(others)})</summary><ul>{items}</ul></details>")
    if section.inputs:
        rows = "".join(f'<tr><td>{escape(name)}</td><td class="hash">{digest}</td></tr>'
                       for name, digest in section.inputs.items())
        parts.append(f"<details><summary>inputs and their SHA-256 ({len(section.inputs)})</summary>"
                     f"<table>{rows}</table></details>")
    return "\n".join([*parts, "</section>"])


def _figure(picture: Picture) -> str:
    if picture.is_plain:
        return f"<figure>{picture.svg}</figure>"
    data = base64.b64encode(picture.svg.encode()).decode()
    return f'<figure><img alt="{escape(picture.name)}" src="data:image/svg+xml;base64,{data}"></figure>'
