"""The prescriptions of the validation are real people's: each stands in the data set with the same numbers. All configurations are valid."""
import csv
import json
import re
import unittest

from sturm_process import SOURCE, sturm

DATA_SET = SOURCE / "configs/data/papila_prescriptions.csv"
PATIENT = re.compile(r"P\d+-O[DS]$")


def data_set():
    """{"P172-OS": (sphere, cylinder, axis)}"""
    with DATA_SET.open(encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {f"{row['id']}-{row['eye']}": tuple(float(row[key]) for key in ("sph_D", "cyl_D", "axis_deg")) for row in rows}


def patients(experiment):
    prescriptions = json.loads(experiment.read_text()).get("ellipses", {}).get("prescriptions", [])
    return {p["id"]: (p["sphere_D"], p.get("cylinder_D", 0), p.get("axis_deg")) for p in prescriptions if PATIENT.match(p["id"])}


class Prescriptions(unittest.TestCase):
    def test_each_patient_stands_in_the_data_set(self):
        known = data_set()
        self.assertGreater(len(known), 400)
        for experiment in sorted((SOURCE / "configs/experiments").glob("*.json")):
            for name, (sphere, cylinder, axis) in patients(experiment).items():
                self.assertIn(name, known)
                self.assertEqual((sphere, cylinder, axis), known[name], f"{experiment.name}: {name}")

    def test_the_validation_uses_patients(self):
        self.assertGreaterEqual(len(patients(SOURCE / "configs/experiments/validation.json")), 10)

    def test_the_data_set_is_plausible(self):
        # Guards the copy against shifted columns and swapped digits.
        for name, (sphere, cylinder, axis) in data_set().items():
            self.assertTrue(-20 <= sphere <= 20 and -8 <= cylinder <= 0 and 0 <= axis <= 180, name)


class Configurations(unittest.TestCase):
    def test_all_are_valid(self):
        checked = 0
        for path in sorted((SOURCE / "configs").rglob("*.json")):
            if path.parent.name == "schemas" or "format" not in (document := json.loads(path.read_text())):
                continue  # schemas are checked by the program when it starts using them; data files have no format of ours
            with self.subTest(path.name):
                process = sturm("validate", path)
                self.assertEqual(process.returncode, 0, process.stderr)
                self.assertIn(document["format"], process.stdout)
                checked += 1
        self.assertGreaterEqual(checked, 4)

    def test_schema_names_are_the_files(self):
        listed = sturm("schema").stdout.split()
        self.assertEqual(sorted(listed), sorted(path.name.removesuffix(".schema.json") for path in (SOURCE / "configs/schemas").iterdir()))
        for name in listed:
            with self.subTest(name):
                schema = json.loads(sturm("schema", name).stdout)
                self.assertEqual(schema["$schema"], "http://json-schema.org/draft-07/schema#")
                self.assert_self_contained(schema, schema)

    def assert_self_contained(self, node, schema):
        """No reference leaves the document, and every object says what other keys it takes."""
        if isinstance(node, dict):
            if isinstance(node.get("$ref"), str):
                self.assertTrue(node["$ref"].startswith("#/definitions/"), node["$ref"])
                self.assertIn(node["$ref"].split("/")[2], schema["definitions"])
            if isinstance(node.get("properties"), dict) and "type" in node:
                self.assertIn("additionalProperties", node)  # an unknown key is an error everywhere
        for child in node.values() if isinstance(node, dict) else node if isinstance(node, list) else []:
            self.assert_self_contained(child, schema)


if __name__ == "__main__":
    unittest.main()
