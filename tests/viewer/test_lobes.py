"""Densities with which surfaces scatter, as the page's shader states them where it weighs a lamp's choice against a path's own: against closed forms, written
out here from [Walter2007] and Heitz 2018. A wrong one leaves every mean as it is, since both choices are weighed by it, and only makes noise; so no picture shows it."""
import array
import base64
import math

from page_in_browser import PageTest, main

MATT, FACETS = 1, 2  # lobes of viewer/shaders/scatter.glsl
ROUGHNESS = {"metal": 0.5, "coat": 0.6}
COAT_INDEX = 1.5
SCENE = {"format": "sturm.scene/1",
         "materials": {"metal": {"type": "conductor", "metal": "copper", "roughness": ROUGHNESS["metal"]},
                       "coat": {"type": "plastic", "albedo": [0.1, 0.3, 0.2], "roughness": ROUGHNESS["coat"], "index": COAT_INDEX}, "lamp": {"emission": [1, 1, 1]}},
         "spheres": [{"center_m": [0.3 * k, 0, -2], "radius_m": 0.1, "material": name} for k, name in enumerate(("metal", "coat", "lamp"))]}
VIEW = {"format": "sturm.render/1", "scene": SCENE, "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 30, "resolution": [32, 32]},
        "eye": {"prescription": {"sphere_D": 0, "cylinder_D": 0, "axis_deg": 0, "vertex_distance_mm": 0}, "pupil_diameter_mm": 4, "accommodation": {"mode": "relaxed"}},
        "method": {"type": "path_trace", "ray_model": "power_matrix", "samples_per_pixel": 1, "max_bounces": 2}, "seed": 1}
# The shader of a pixel's path with another beginning: pairs of directions in, what it says of them out.
ASK = """
  const [material, lobe, directions, right, wrong] = arguments, {gpu, scene, pictures} = window.sturmViewer.app, {gl} = gpu, own = gl.shaderSource.bind(gl), texts = [];
  gl.shaderSource = (shader, text) => { texts.push(text); own(shader, text); };
  pictures.programs.compiled.clear();
  pictures.programs.use('eye');
  delete gl.shaderSource;
  const name = window.sturmViewer.app.data.materials.findIndex((m) => m.name === material), count = directions.length / 8;
  const own_beginning = `uniform sampler2D u_directions;
    void main() {
      int k = 2 * int(gl_FragCoord.x);
      float density;
      vec3 value = lobe_towards(${name}, ${lobe}, texelFetch(u_directions, ivec2(k, 0), 0).xyz, texelFetch(u_directions, ivec2(k + 1, 0), 0).xyz, density);
      result = vec4(value, density);
    }`;
  if (!texts[1].includes(right)) throw new Error(`the shader has no ${right}`);
  const program = gpu.program('lobes', texts[0], texts[1].replace(right, wrong).replace('void main()', 'void drawn()') + own_beginning);
  const table = gpu.floats(new Float32Array(directions), 2 * count, 1), target = gpu.target(count, 1);
  scene.bind(program.use()).texture('u_directions', table);
  gpu.into(target);
  gpu.fill(false);
  const values = gpu.read(target);
  return btoa(String.fromCharCode(...new Uint8Array(values.buffer)));"""


def direction(polar_deg, azimuth_deg):
    polar, azimuth = math.radians(polar_deg), math.radians(azimuth_deg)
    return (math.sin(polar) * math.cos(azimuth), math.sin(polar) * math.sin(azimuth), math.cos(polar))


PAIRS = [(direction(p, 20), direction(q, a)) for p in (2, 30, 55, 78) for q in (5, 40, 65, 85) for a in (25, 110, 200, 330)]


def masking(w, alpha):
    """G₁ of Smith for GGX."""
    tangent2 = (w[0] ** 2 + w[1] ** 2) / w[2] ** 2
    return 2 / (1 + math.sqrt(1 + alpha ** 2 * tangent2))


def facets(outgoing, incoming, roughness):
    """Density [1/sr] of reflection at visible normals; f·cos for a reflectance of 1; cosine at the facet."""
    alpha, sum_ = roughness ** 2, [a + b for a, b in zip(outgoing, incoming)]
    length = math.hypot(*sum_)
    h = [x / length for x in sum_]
    distribution = alpha ** 2 / (math.pi * (h[2] ** 2 * (alpha ** 2 - 1) + 1) ** 2)
    cosine = sum(a * b for a, b in zip(outgoing, h))
    g_out, g_in = masking(outgoing, alpha), masking(incoming, alpha)
    both = 1 / (1 / g_out + 1 / g_in - 1)  # masking and shadowing, correlated in height
    visible = distribution * g_out * cosine / outgoing[2]
    return visible / (4 * cosine), distribution * both / (4 * outgoing[2]), cosine


def fresnel(cosine, index):
    inner = math.sqrt(1 - (1 - cosine ** 2) / index ** 2)
    return 0.5 * (((index * cosine - inner) / (index * cosine + inner)) ** 2 + ((cosine - index * inner) / (cosine + index * inner)) ** 2)


class Lobes(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls().page_of(VIEW)

    def said(self, material, lobe, right="", wrong=""):
        """What the shader says of each pair: value of one colour, density."""
        numbers = [x for pair in PAIRS for w in pair for x in (*w, 0)]
        values = array.array("f")
        values.frombytes(base64.b64decode(self.browser.run(ASK, material, lobe, numbers, right, wrong)))
        return [(values[4 * k], values[4 * k + 3]) for k in range(len(PAIRS))]

    def off(self, said, expected):
        """Largest relative deviation of densities."""
        return max(abs(density - e) / e for (_, density), e in zip(said, expected, strict=True))

    def test_densities_of_facets_are_those_of_visible_normals(self):
        for material, roughness in ROUGHNESS.items():
            with self.subTest(material=material):
                expected = [facets(*pair, roughness) for pair in PAIRS]
                said = self.said(material, FACETS)
                off = self.off(said, [e[0] for e in expected])
                print(f"{material}: densities of facets off by {off:.1e}", flush=True)
                self.assertLess(off, 1e-5)  # single precision
                # Mistakes of the kind that only this test sees.
                densities = [e[0] for e in expected]
                for right, wrong in (("density = scale / masked;", "density = scale;"), ("density = scale / masked;", "density = 4.0 * scale / masked;"),
                                     ("scale = a2 / (4.0 * pi * q * q * outgoing.z)", "scale = a2 / (4.0 * pi * q * q * incoming.z)")):
                    self.assertGreater(self.off(self.said(material, FACETS, right, wrong), densities), 1e-2, wrong)
        for (value, _), (_, reflected, cosine) in zip(self.said("coat", FACETS), [facets(*pair, ROUGHNESS["coat"]) for pair in PAIRS], strict=True):
            expected = reflected * fresnel(cosine, COAT_INDEX)
            self.assertAlmostEqual(value, expected, delta=1e-5 * expected)

    def test_matt_lobes_scatter_by_the_cosine(self):
        self.assertLess(self.off(self.said("coat", MATT), [incoming[2] / math.pi for _, incoming in PAIRS]), 1e-6)


if __name__ == "__main__":
    main()
