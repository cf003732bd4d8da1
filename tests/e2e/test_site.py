"""The documents as a site: every document is on it, and a reference of the code; no link of it is dead, and its search works from files, without a server."""
import html.parser
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import urllib.parse

from sturm_process import SOURCE
from webdriver import Browser


class Page(html.parser.HTMLParser):
    """Anchors of a page, and where its links and pictures point."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.targets = set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        named = dict(attributes)
        self.anchors |= {named[key] for key in ("id", "name") if key in named}
        self.targets += [named[key] for key in ("href", "src") if named.get(key)]


def dead_targets(pages):
    """"PAGE: TARGET" for every target that is neither a file of the site nor an anchor of one of its pages."""
    for path, page in pages.items():
        for target in page.targets:
            parts = urllib.parse.urlsplit(target)
            if parts.scheme:
                continue
            place = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            fragment = urllib.parse.unquote(parts.fragment)
            if not place.exists() or (fragment and place in pages and fragment not in pages[place].anchors):
                yield f"{path.name}: {target}"


@unittest.skipUnless(shutil.which("mkdocs") and shutil.which("doxygen"), "MkDocs or Doxygen is not installed (scripts/site installs them)")
class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="sturm_site_", ignore_cleanup_errors=True)
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name).resolve() / "site"
        command = ["mkdocs", "build", "--quiet", "--strict", "-f", SOURCE / "site/mkdocs.yml", "-d", cls.folder]
        cls.process = subprocess.run(command, capture_output=True, text=True)

    def test_every_document_is_on_it(self):
        self.assertEqual((self.process.returncode, self.process.stderr), (0, ""))
        wanted = {path.relative_to(SOURCE / "docs").with_suffix(".html").as_posix() for path in (SOURCE / "docs").rglob("*.md")}
        listed = {line.strip().rsplit(" ", 1)[-1] for line in (SOURCE / "site/mkdocs.yml").read_text().splitlines() if line.endswith(".md")}
        for page in sorted(wanted):
            with self.subTest(page=page):
                self.assertTrue((self.folder / page).is_file())
                self.assertIn(page.removesuffix(".html") + ".md", listed)

    def text_of(self, page):
        """The HTML of a page's document, without the navigation beside it."""
        return (self.folder / f"{page}.html").read_text(encoding="utf-8").split('role="main"')[1]

    def test_a_link_to_a_source_names_it(self):
        """Sources are not on the site; the link becomes its text and the path."""
        text = (SOURCE / "README.md").read_text(encoding="utf-8")
        links = re.findall(r"\[([^\]]+)\]\(((?:ci|configs|reports|tests)/[^)#]+)\)", text)
        self.assertTrue(links)
        for words, source in links:
            self.assertIn(f"{words} (<code>{source}</code>)", self.text_of("index"))

    def test_the_reference_is_on_it(self):
        """A page for each room with public headers and one for Python; links to a room's folder lead there on the site."""
        rooms = {line.split("/")[0] for line in (SOURCE / "cmake/public_headers.txt").read_text().splitlines() if not line.startswith("#")}
        self.assertEqual({path.stem for path in (self.folder / "reference").iterdir()}, rooms | {"python"})
        listed = set(re.findall(r"reference/(\w+)\.md", (SOURCE / "site/mkdocs.yml").read_text()))
        self.assertEqual(listed, rooms | {"python"})
        for page, target in (("library", "reference/conoid.html"), ("library", "reference/conoid.html#conoidtracingfootprinth"), ("python", "reference/python.html")):
            self.assertIn(f'href="{target}"', self.text_of(page))
        self.assertIn("lensmodeleyeh", Page(self.folder / "reference/lensmodel.html").anchors)

    def test_no_link_is_dead(self):
        pages = {path: Page(path) for path in self.folder.rglob("*.html") if path.name != "404.html"}
        self.assertEqual(list(dead_targets(pages)), [])

    def browser(self):
        profile = tempfile.TemporaryDirectory(prefix="sturm_site_profile_", ignore_cleanup_errors=True)
        self.addCleanup(profile.cleanup)
        browser = Browser(profile.name)
        self.addCleanup(browser.close)
        return browser

    def test_tables_are_as_wide_as_the_page_and_have_their_pictures(self):
        """The theme once kept each cell on one line: sentences were cut off, and the gallery's pictures had no width."""
        browser = self.browser()
        for page in ("index", "first_steps", "commands/lens", "reference/io", "reference/python"):
            browser.open(self.folder / f"{page}.html")
            cut = browser.run("return [...document.querySelectorAll('.wy-table-responsive')].filter((box) => box.scrollWidth > box.clientWidth + 1).length;")
            narrow = browser.run("return [...document.images].filter((image) => image.clientWidth < 200).map((image) => image.src);")
            self.assertEqual((page, cut, narrow), (page, 0, []))

    def test_search_works_from_files(self):
        browser = self.browser()
        for words, page in (("naked_eye_footprint", "reference/conoid.html"), ("circle of least confusion", "theory.html")):
            browser.open(self.folder / "search.html")
            browser.type("#mkdocs-search-query", words)
            found = browser.run("return [...document.querySelectorAll('#mkdocs-search-results a')].map((link) => link.href);")
            self.assertTrue(any(page in address for address in found), found)
        browser.click("#mkdocs-search-results a")
        self.assertNotEqual(browser.text("h1"), "Search Results")
        self.assertEqual(browser.console(), [])


if __name__ == "__main__":
    unittest.main()
