#include "pathtrace/scene/gltf/textures.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/json/data_uri.h"
#include "pathtrace/scene/gltf/members.h"
#include "pathtrace/scene/gltf/uri.h"
#include "pathtrace/scene/texture_file.h"

namespace sturm::gltf {

namespace {

TextureWrap wrap_of(const Json& sampler, const char* key, const Source& where) {
  switch (number(sampler, key, where, 10497)) {
    case 10497:
      return TextureWrap::Repeat;
    case 33071:
      return TextureWrap::Clamp;
    case 33648:
      return TextureWrap::Mirror;
    default:
      (where / key).fail(sampler[key], "10497 (repeat), 33071 (clamp to edge) or 33648 (mirrored repeat)");
  }
}

/// KHR_texture_transform as a matrix on coordinates whose v runs upwards. In the file v runs downwards, and there
///
///     (u, v) → offset + R (scale_u u, scale_v v)     R = [cos sin; −sin cos]
///
/// so that a quarter turn takes (u, v) to (v, −u): counter-clockwise as the picture is seen.
Eigen::Matrix<float, 2, 3> transform_of(const Json& extension, const Source& where) {
  const std::vector<double> offset = reals(extension, "offset", where, {0.0, 0.0}),
                            scale = reals(extension, "scale", where, {1.0, 1.0});
  const double angle = real(extension, "rotation", where, 0.0), c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix3d transform, flip;
  transform << c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1], 0.0, 0.0, 1.0;
  flip << 1.0, 0.0, 0.0, 0.0, -1.0, 1.0, 0.0, 0.0, 1.0;
  const Eigen::Matrix<float, 2, 3> upwards = (flip * transform * flip).topRows<2>().cast<float>();
  if (!upwards.allFinite()) where.fail(extension, "a finite transform");
  return upwards;
}

std::shared_ptr<const Image> alpha_of(const Image& stored) {
  if (stored.channels != 2 && stored.channels != 4) return nullptr;
  auto alpha = std::make_shared<Image>(stored.width, stored.height, 1);
  for (int y = 0; y < alpha->height; ++y)
    for (int x = 0; x < alpha->width; ++x) *alpha->at(x, y) = stored.at(x, y)[stored.channels - 1];
  const auto& pixels = alpha->pixels;
  if (std::all_of(pixels.begin(), pixels.end(), [](float a) { return a >= 1.0f; })) return nullptr;
  return alpha;
}

}  // namespace

Eigen::Vector3f mean_of(const Image& picture) {
  Eigen::Vector3d sum(0.0, 0.0, 0.0);
  for (std::size_t i = 0; i < picture.pixels.size(); i += 3)
    sum += Eigen::Vector3d(picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2]);
  return (3.0 / static_cast<double>(picture.pixels.size()) * sum).cast<float>();
}

std::optional<Texture> Textures::read(const Json& parent, const char* key, const Source& where,
                                      TextureEncoding encoding, const std::string& material) {
  if (!parent.contains(key)) return std::nullopt;
  const Json& info = object(parent, key, where);
  const Source place = where / key;
  const Json& textures = list(document_.json(), "textures", document_.root());
  const auto named = index(info, "index", place, textures.size(), "texture");
  if (!named) place.fail(info, "an object with \"index\"");
  const Source texture_place = document_.root() / "textures" / *named;
  const Json& texture = textures[*named];
  if (!texture.is_object()) texture_place.fail(texture, "an object");
  Texture result;
  result.set = number(info, "texCoord", place, 0);
  if (const Json* transform = extension(info, "KHR_texture_transform")) {
    const Source extension_place = place / "extensions" / "KHR_texture_transform";
    result.mapping.picture_from_mesh = transform_of(*transform, extension_place);
    result.set = number(*transform, "texCoord", extension_place, result.set);
  }
  apply_sampler(texture, texture_place, result);
  const Picture& shown = picture(image_of(texture, texture_place), encoding, material);
  result.colours = shown.colours;
  result.alpha = shown.alpha;
  return result;
}

void Textures::apply_sampler(const Json& texture, const Source& where, Texture& result) const {
  static const Json none = Json::object();
  const Json& samplers = list(document_.json(), "samplers", document_.root());
  const auto named = index(texture, "sampler", where, samplers.size(), "sampler");
  const Json& sampler = named ? samplers[*named] : none;
  const Source place = named ? document_.root() / "samplers" / *named : where;
  if (!sampler.is_object()) place.fail(sampler, "an object");
  result.mapping.wrap_u = wrap_of(sampler, "wrapS", place);
  result.mapping.wrap_v = wrap_of(sampler, "wrapT", place);
  if (spec_.texture_wrap) result.mapping.wrap_u = result.mapping.wrap_v = *spec_.texture_wrap;
  constexpr std::uint64_t nearest = 9728, linear = 9729;
  result.nearest = spec_.texture_filter == TextureFilter::Nearest ||
                   (!spec_.texture_filter_is_stated && number(sampler, "magFilter", place, linear) == nearest);
}

std::size_t Textures::image_of(const Json& texture, const Source& where) const {
  const std::size_t count = list(document_.json(), "images", document_.root()).size();
  if (const auto plain = index(texture, "source", where, count, "image")) return *plain;
  // Pictures of other formats: what OpenImageIO cannot read says so when it is read.
  for (const char* name : {"EXT_texture_webp", "EXT_texture_avif", "MSFT_texture_dds", "KHR_texture_basisu"})
    if (const Json* other = extension(texture, name)) {
      const Source place = where / "extensions" / name;
      if (std::string(name) == "KHR_texture_basisu")
        throw InputError(place.file, place.pointer, "a KTX2 texture", "a texture that also has a plain \"source\"");
      if (const auto source = index(*other, "source", place, count, "image")) return *source;
    }
  where.fail(texture, "a texture with the \"source\" of its picture");
}

const Textures::Picture& Textures::picture(std::size_t image, TextureEncoding encoding, const std::string& material) {
  const auto [at, fresh] = pictures_.try_emplace({image, encoding});
  if (!fresh) return at->second;
  const Image linear = linear_picture(image, encoding, material);
  at->second = {colours_of(linear), alpha_of(linear)};
  return at->second;
}

Image Textures::linear_picture(std::size_t image, TextureEncoding encoding, const std::string& material) {
  const Source where = document_.root() / "images" / image;
  const Json& picture = document_.json()["images"][image];
  const std::string name = document_.file().string() + ", " + material + ", image " + std::to_string(image);
  std::vector<std::string> chosen;
  const auto embedded = [&](const void* bytes, std::size_t count) {
    return read_embedded_texture({static_cast<const unsigned char*>(bytes), count}, encoding, StatedIn::Model, name,
                                 chosen);
  };
  const auto read = [&] {
    if (!picture.contains("uri")) {
      const auto bytes = document_.view(number(picture, "bufferView", where));
      return embedded(bytes.data(), bytes.size());
    }
    const std::string uri = text(picture, "uri", where, "");
    if (const auto data = data_of_uri(uri, where / "uri")) return embedded(data->data(), data->size());
    return read_texture(file_of_uri(uri, document_.file(), where / "uri"), encoding, StatedIn::Model, chosen);
  };
  Image linear = read();
  for (const std::string& what : chosen) notes_.push_back(document_.file().filename().string() + ": " + what);
  return linear;
}

}  // namespace sturm::gltf
