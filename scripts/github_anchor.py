"""The anchor that GitHub gives a heading."""
import re
import unicodedata


def anchor(heading):
    """Words and hyphens in lower case, without markup and punctuation; blanks become hyphens."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"<[^>]+>", "", heading)).replace("`", "")
    kept = [c for c in text.lower() if c in "- _" or unicodedata.category(c)[0] in "LM" or unicodedata.category(c) in ("Nd", "Pc")]
    return "".join(kept).strip().replace(" ", "-")
