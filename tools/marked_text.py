"""Text between two marks of a page."""


class LostMarks(Exception):
    """A page without its marks."""


def replace_marked(text: str, begin: str, end: str, fresh: str, name: str) -> str:
    """The text with <fresh> between its marks."""
    start = text.find(begin)
    stop = text.find(end, start)
    if start < 0 or stop < 0:
        raise LostMarks(f"{name} has lost the marks around what is generated: {begin.splitlines()[0]} ... {end}")
    return text[: start + len(begin)] + fresh + text[stop:]
