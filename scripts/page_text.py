"""Pieces of pages that commands write: tables, what stands between two markers, shares with their intervals."""
import math
import re
import textwrap

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


STAYS = re.compile(r"^\s*(\||#|!\[|<!--)|^\s*$")
ITEM = re.compile(r"^(\s*)([-*]|\d+\.)\s+")


def folded(page, width=120):
    """The page with paragraphs and list items filled anew, so that no line has to be scrolled; tables, code, headings and pictures stay."""
    lines, block, code = [], [], False

    def close():
        if block:
            item = ITEM.match(block[0])
            indent = " " * (len(item.group(0)) if item else 0)
            lines.extend(textwrap.wrap(" ".join(line.strip() for line in block), width, initial_indent=item.group(1) if item else "",
                                       subsequent_indent=indent, break_long_words=False, break_on_hyphens=False))
            block.clear()

    for line in page.split("\n"):
        fence = line.lstrip().startswith("```")
        if code or fence or STAYS.match(line):
            close()
            lines.append(line)
            code ^= fence
            continue
        if ITEM.match(line):
            close()
        block.append(line)
    close()
    return "\n".join(lines)
