"""Pieces of pages that commands write: tables, what stands between two markers, shares with their intervals."""
import math
import re

END = "<!-- end of table -->"


def written_by(command, program=""):
    """First lines of a generated page, with the commit of the program whose results it shows."""
    return f"<!-- written by {command} -->\n" + (f"<!-- program {program} -->\n" if program else "")


def table(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(str(cell).replace("|", "\\|") for cell in line) + " |" for line in lines)


def with_table(page, name, body):
    """The page with what stands after `<!-- table: NAME -->` replaced."""
    pattern = re.compile(rf"(<!-- table: {re.escape(name)} -->\n).*?({re.escape(END)})", re.DOTALL)
    if len(pattern.findall(page)) != 1:
        raise ValueError(f"the page has not exactly one <!-- table: {name} --> … {END}")
    return pattern.sub(lambda match: f"{match.group(1)}\n{body}\n\n{match.group(2)}", page)


def wilson(hits, of, z=1.959964):
    """95 % interval of a share (Wilson 1927)."""
    if of == 0:
        return 0.0, 1.0
    share, spread = hits / of, z * z / of
    middle = (share + spread / 2) / (1 + spread)
    half = z / (1 + spread) * math.sqrt(share * (1 - share) / of + spread / of / 4)
    return max(0.0, middle - half), min(1.0, middle + half)


def share(hits, of):
    """`206 of 216 (95.4 %, 91.7 to 97.5)`: the interval is Wilson's of 95 %."""
    if of == 0:
        return "none of these"
    low, high = wilson(hits, of)
    return f"{hits} of {of} ({100 * hits / of:.1f} %, {100 * low:.1f} to {100 * high:.1f})"
