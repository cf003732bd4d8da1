"""The shipped accuracy study of conoid tracing through spectacles, as it stands."""
import time
import unittest

from sturm_process import SOURCE, FolderTest, strict_json


class ConoidAccuracy(FolderTest):
    def test_the_shipped_study_passes_its_gates(self):
        start = time.monotonic()
        self.succeed("run", SOURCE / "configs/experiments/conoid_accuracy.json", "--out", self.folder / "out", "--quiet", timeout=600)
        seconds = time.monotonic() - start
        report = strict_json((self.folder / "out/report.json").read_text())
        self.assertTrue(report["verdict"]["passed"], report["verdict"])
        self.assertLess(seconds, 600, "it takes seconds; an unoptimised build some minutes")
        ids = {lens["id"] for lens in report["lens_study"]["lenses"]}
        real = {"P069-OS", "P172-OS", "P195-OD", "P281-OS", "P157-OD", "P250-OD", "P128-OS", "P250-OS"}
        self.assertLessEqual(real, ids)

    def test_its_prescriptions_are_those_of_the_data(self):
        rows = [line.split(",") for line in (SOURCE / "configs/data/papila_prescriptions.csv").read_text().splitlines()[2:]]
        measured = {f"{row[1]}-{row[0]}": tuple(float(x) for x in row[4:7]) for row in rows}
        study = strict_json((SOURCE / "configs/experiments/conoid_accuracy.json").read_text())["lens_study"]
        checked = 0
        for lens in study["lenses"]:
            if lens["note"].startswith("constructed"):
                continue
            rx = lens["prescription"]
            self.assertEqual((rx["sphere_D"], rx["cylinder_D"], rx["axis_deg"]), measured[lens["id"]], lens["id"])
            checked += 1
        self.assertGreaterEqual(checked, 8)


if __name__ == "__main__":
    unittest.main()
