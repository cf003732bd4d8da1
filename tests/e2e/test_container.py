"""The recipe of a container: its steps name what is there, and where podman or docker works, it is built and answers."""
import json
import re
import shutil
import subprocess
import unittest

from sturm_process import SOURCE

RECIPE = SOURCE / "ci/container/Containerfile"
TEXT = RECIPE.read_text(encoding="utf-8")


def engine():
    for name in ("podman", "docker"):
        if shutil.which(name) and subprocess.run([name, "info"], capture_output=True, check=False).returncode == 0:
            return name
    return None


class Recipe(unittest.TestCase):
    def test_its_steps_name_what_is_there(self):
        copied = re.findall(r"^COPY (?!--from)(.*) \S+$", TEXT, re.MULTILINE)
        self.assertEqual(copied, ["scripts/dependencies.txt", "."])
        for path in copied:
            self.assertTrue((SOURCE / path).exists(), path)
        presets = {preset["name"] for preset in json.loads((SOURCE / "CMakePresets.json").read_text())["configurePresets"]}
        self.assertLessEqual(set(re.findall(r"--preset (\S+)", TEXT)), presets)
        options = (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")
        for option in re.findall(r"-D(\w+)=", TEXT):
            self.assertIn(f"option({option} ", options)

    def test_both_stages_stand_on_the_system_that_packages_are_for(self):
        self.assertEqual(set(re.findall(r"^FROM (\S+)", TEXT, re.MULTILINE)), {"debian:12"})

    def test_it_is_compiled_for_any_machine(self):
        configuring = re.search(r"cmake --preset (\S+)", TEXT).group(1)
        self.assertEqual(configuring, "portable")
        for place in re.findall(r"build/(\w+)/CPackConfig", TEXT):
            self.assertEqual(place, configuring)

    @unittest.skipUnless(engine(), "neither podman nor docker works here")
    def test_it_is_built_and_answers(self):
        subprocess.run([engine(), "build", "-f", RECIPE, "-t", "sturm-test", SOURCE], check=True)
        printed = subprocess.run([engine(), "run", "--rm", "sturm-test", "ellipse", "--rx", "-2.00 DS", "--pupil", "4", "--distance", "1"],
                                 check=True, capture_output=True, text=True).stdout
        self.assertIn("1", printed)


if __name__ == "__main__":
    unittest.main()
