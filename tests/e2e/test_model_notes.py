"""What notes say of COLLADA, PLY and STL models is true, and nothing that changes the picture goes without one."""
import unittest

from model_pictures import RED, ModelTest

DAE = """<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t">{}</technique></profile_COMMON></effect></library_effects>
<library_materials><material id="paint-id" name="paint"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g" name="square"><mesh><source id="p"><float_array id="pa" count="12">-1 -1 -2 1 -1 -2 1 1 -2 -1 1 -2</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><polylist count="1" material="M"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4</vcount><p>0 1 2 3</p></polylist>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="vs"><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="M" target="#paint-id"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#vs"/></scene></COLLADA>"""
DIFFUSE = "<diffuse><color>0.1 0.2 0.3 1</color></diffuse>"
PLY = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n{}element face 1\nproperty list uchar int vertex_indices\nend_header\n" \
      "-1 -1 -2{c}\n1 -1 -2{c}\n1 1 -2{c}\n-1 1 -2{c}\n4 0 1 2 3\n"


class ModelNotes(ModelTest):
    def test_specular_is_noted_where_the_file_states_it(self):
        for shading, stated in (("<lambert>{}</lambert>", False), ("<constant></constant>", False), ("<phong>{}</phong>", False), ("<blinn>{}</blinn>", False),
                                ("<phong>{}<specular><color>0 0 0 1</color></specular></phong>", False),
                                ("<lambert>{}<specular><color>1 1 1 1</color></specular></lambert>", False),
                                ("<phong>{}<specular><color>0.5 0.5 0.5 1</color></specular><shininess><float>20</float></shininess></phong>", True),
                                ("<blinn>{}<specular><color sid='s'>0.25 0 0 1</color></specular></blinn>", True)):
            with self.subTest(shading):
                self.write("m.dae", DAE.format(shading.format(DIFFUSE)))
                picture = self.model("m.dae")
                self.assertEqual(any("specular" in note for note in self.notes), stated, self.notes)
                if "constant" not in shading:
                    self.assert_albedo(picture, 16, 16, (0.1, 0.2, 0.3))

    def test_formats_without_materials(self):
        self.write("m.ply", PLY.format("", c=""))
        self.assert_albedo(self.model("m.ply"), 20, 20, (0.6, 0.6, 0.6))
        self.assertEqual(self.notes, [])
        self.write("m.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex -1 -1 -2\nvertex 1 -1 -2\nvertex 1 1 -2\nendloop\nendfacet\nendsolid s\n")
        self.assert_albedo(self.model("m.stl"), 20, 20, (0.6, 0.6, 0.6))  # as PLY and OBJ files without materials
        self.assertEqual(self.notes, [])

    def test_vertex_colours_of_a_scan(self):
        colours = "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        self.write("m.ply", PLY.format(colours, c=" 255 0 0"))
        self.assert_albedo(self.model("m.ply"), 16, 16, RED)
        self.assert_noted("m.ply", "vertex colours")
        self.write("m.ply", PLY.format(colours, c=" 51 102 255"))
        self.assert_albedo(self.model("m.ply", texture_encoding="linear"), 16, 16, (0.2, 0.4, 1))
        self.assert_albedo(self.model("m.ply"), 16, 16, (0.0331, 0.1329, 1))  # ((v + 0.055) / 1.055)^2.4


if __name__ == "__main__":
    unittest.main()
