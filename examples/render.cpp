// Renders the document that the first argument names into the EXR file of the second.
#include <sturm/io/files/error.h>
#include <sturm/io/images/exr.h>
#include <sturm/stages/render_stage.h>

#include <cstdio>

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  const auto spec = sturm::read_render_spec(sturm::load_json(argv[1]), argv[1]);
  const auto output =
      sturm::render_view(spec, [](double fraction) { std::fprintf(stderr, "\r%3.0f %%", 100.0 * fraction); });
  sturm::write_exr(argv[2], output.image);
} catch (const sturm::InputError& error) {
  std::fprintf(stderr, "%s\nat %s: expected %s\n", error.what(), error.pointer().c_str(), error.expected().c_str());
  return 2;
}
